#include "replays/html/scene_columns.hpp"

#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "replays/coding/byte_io.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/html/sample_scene.hpp"

namespace fulbito {
namespace {

/// Reads columns like the page's script.
class Script {
 public:
  explicit Script(const std::string& bytes) : bytes_(bytes) {}
  std::int64_t next() {
    std::uint64_t value = 0;
    int shift = 0;
    for (;; shift += 7) {
      REQUIRE(at_ < bytes_.size());
      const auto byte = static_cast<std::uint8_t>(bytes_[at_++]);
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80) break;
    }
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  std::vector<std::int64_t> column(const PageScene& scene) {
    std::vector<std::int64_t> values;
    std::int64_t last = 0, change = 0;
    for (std::size_t r = 0; r < scene.rows.size(); ++r) {
      const bool first = r == scene.plays[0].row || r == scene.plays[1].row;
      if (first) change = 0;
      values.push_back(last + change + next());
      change = first ? 0 : values.back() - last;
      last = values.back();
    }
    return values;
  }
  std::vector<std::int64_t> plain(std::size_t count) {
    std::vector<std::int64_t> values;
    for (std::int64_t last = 0; values.size() < count; values.push_back(last)) last += next();
    return values;
  }
  bool atEnd() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace

TEST_CASE("columns give every pose back within half a step", "[unit]") {
  const PageScene scene = test::sampleScene();
  Script script(packedColumns(scene));
  const auto ticks = script.column(scene);
  for (std::size_t r = 0; r < scene.rows.size(); ++r) CHECK(ticks[r] == scene.rows[r].tick);
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    const auto x = script.column(scene), y = script.column(scene);
    const auto heading = hasHeading(scene.bodies[body]) ? script.column(scene) : std::vector<std::int64_t>{};
    for (std::size_t r = 0; r < scene.rows.size(); ++r) {
      if (scene.plays[r < scene.plays[1].row ? 0 : 1].present[body] == 0) continue;
      const Pose2& pose = scene.rows[r].poses[body];
      CHECK(std::abs(static_cast<double>(x[r]) * kPagePlaceStep - pose.position.x) <=
            kPagePlaceStep / 2 + 1e-12);
      CHECK(std::abs(static_cast<double>(y[r]) * kPagePlaceStep - pose.position.y) <=
            kPagePlaceStep / 2 + 1e-12);
      if (heading.empty()) continue;
      const double turn = math::wrapAngle(static_cast<double>(heading[r]) * kPageHeadingStep - pose.heading);
      CHECK(std::abs(turn) <= kPageHeadingStep / 2 + 1e-12);
    }
  }
  for (const auto& wanted :
       {std::vector<std::int64_t>{0, 10, 21, 31}, {0, -4, -7, -11}, {-46, -46, -46, -46}, {46, 46, 46, 46}}) {
    CHECK(script.plain(4) == wanted);
  }
  CHECK(script.atEnd());
}

TEST_CASE("headings go on over a full turn within a play", "[unit]") {
  const PageScene scene = test::sampleScene();
  Script script(packedColumns(scene));
  for (int i = 0; i < 3; ++i) script.column(scene);
  const auto heading = script.column(scene);  // heading of the first robot, which turns by 0.682 rad per row
  for (std::size_t r = 1; r < scene.plays[1].row; ++r)
    CHECK(std::abs(heading[r] - heading[r - 1] - 136) <= 1);
}

TEST_CASE("a body that is away costs next to nothing and leaves no trace", "[unit]") {
  PageScene scene = test::sampleScene();
  const std::string before = packedColumns(scene);
  for (std::size_t r = scene.plays[1].row; r < scene.rows.size(); ++r) {
    scene.rows[r].poses[1] = {{1e300, -1e300}, 3.0};
  }
  CHECK(packedColumns(scene) == before);
}

TEST_CASE("drawings are kept field by field", "[unit]") {
  PageScene scene = test::sampleScene();
  const std::size_t without = packedColumns(scene).size();
  using Kind = RecordedDrawing::Kind;
  scene.drawings = {{2, TeamId::kBlue, Kind::kLine, {0.1, 0.2}, {-0.3, 0.4}, 0.0, ""},
                    {4, TeamId::kYellow, Kind::kText, {0.5, -0.2}, {}, 0.0, "here"}};
  const std::string bytes = packedColumns(scene);
  Script script(bytes.substr(without));
  for (const auto& wanted : {std::vector<std::int64_t>{2, 4},
                             {0, 5},
                             {1000, 5000},
                             {2000, -2000},
                             {-3000, 0},
                             {4000, 0},
                             {0, 0}}) {
    CHECK(script.plain(2) == wanted);
  }
  CHECK(script.atEnd());
}

TEST_CASE("what is no number counts as 0", "[unit]") {
  PageScene strange = test::sampleScene(), zero = test::sampleScene();
  strange.rows[0].poses[0].position.x = std::numeric_limits<double>::quiet_NaN();
  zero.rows[0].poses[0].position.x = 0.0;
  CHECK(packedColumns(strange) == packedColumns(zero));
}

}  // namespace fulbito
