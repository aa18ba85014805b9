#include "navigation/guidance_strokes.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

class Eastward final : public HeadingField {
 public:
  double heading(Vec2) const override { return 0.0; }
};

std::vector<GuidanceStroke> strokesOf(const Guidance& guidance, Vec2 goal) {
  std::vector<GuidanceStroke> strokes;
  addStrokes(guidance, {}, goal, strokes);
  return strokes;
}

}  // namespace

TEST_CASE("a path is shown as lines that leave it nowhere", "[unit]") {
  std::vector<Vec2> path;
  for (int i = 0; i <= 50; ++i) path.push_back({0.01 * i, 0.0});
  for (int i = 1; i <= 50; ++i) path.push_back({0.5, 0.01 * i});
  Guidance guidance;
  guidance.kind = GuidanceKind::kPath;
  guidance.path = path;
  const auto strokes = strokesOf(guidance, path.back());
  REQUIRE(strokes.size() == 2);
  CHECK(strokes[0].to == Vec2{0.5, 0.0});
  CHECK(strokes[1].from == strokes[0].to);
  CHECK(strokes[1].to == path.back());
  path.assign(5, {0.2, 0.2});  // all in one place
  guidance.path = path;
  CHECK(strokesOf(guidance, {0.2, 0.2}).size() == 1);
}

TEST_CASE("a field is shown as arrow heads along its way, up to the goal", "[unit]") {
  const Eastward field;
  const auto far = strokesOf(guidanceBy(field), {5.0, 0.0});
  REQUIRE(far.size() == 20);
  CHECK(std::abs(far[0].from.x - 0.06) < 1e-9);
  for (const GuidanceStroke& stroke : far) CHECK(stroke.to.x < stroke.from.x);  // the arrows point east
  CHECK(strokesOf(guidanceBy(field), {0.13, 0.0}).size() == 4);
  CHECK(strokesOf(guidanceBy(field), {}).empty());
}

TEST_CASE("a method that controls the wheels itself shows nothing", "[unit]") {
  Guidance guidance;
  guidance.kind = GuidanceKind::kWheels;
  CHECK(strokesOf(guidance, {1.0, 0.0}).empty());
}

}  // namespace fulbito
