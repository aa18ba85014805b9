#include "navigation/obstacles/clustered_circles.hpp"

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

ClusteredCircles clustered(std::initializer_list<Circle> circles) {
  ClusteredCircles result;
  result.begin(circles.size());
  for (const Circle& circle : circles) result.add(circle);
  result.join();
  return result;
}

void again(ClusteredCircles& circles, std::initializer_list<Circle> next) {
  circles.begin(next.size());
  for (const Circle& circle : next) circles.add(circle);
  circles.join();
}

}  // namespace

TEST_CASE("a ball and a 7.5 cm robot need no extra distance and larger bodies their excess", "[unit]") {
  RobotModel robot;
  CHECK(extraSize({{}, 0.0335, {}}, robot) == Approx(0.0).margin(1e-15));
  CHECK(extraSize({{}, 0.0535, {}}, robot) == Approx(0.02));
  robot.length = robot.width = 0.15;
  CHECK(extraSize({{}, 0.0335, {}}, robot) == Approx(0.0530330086));
}

TEST_CASE("the nearest circle in the way is between robot and goal and reaches over the line", "[unit]") {
  const auto circles =
      clustered({{{0.8, 0.05}, 0.1}, {{0.4, -0.05}, 0.1}, {{0.2, 0.2}, 0.1}, {{-0.2, 0.0}, 0.1}});
  CHECK(circles.nearestBlocking({}, {1.0, 0.0}, 5.0) == 1);
  CHECK(circles.nearestBlocking({}, {1.0, 0.0}, 0.3) == ClusteredCircles::kNone);
  CHECK(circles.nearestBlocking({0.5, 0.0}, {1.0, 0.0}, 5.0) == 0);
  CHECK(circles.nearestBlocking({0.5, 0.0}, {0.7, 0.0}, 5.0) == ClusteredCircles::kNone);
}

TEST_CASE("the turns past a single circle are its tangents", "[unit]") {
  const auto circles = clustered({{{0.5, 0.1}, 0.2}});
  const double bearing = 0.1973955598, half = 0.4030570747;  // atan(0.1 / 0.5), asin(0.2 / sqrt(0.26))
  const Extents turn = circles.extents(0, {}, {1.0, 0.0});
  CHECK(turn.left == Approx(bearing + half).epsilon(1e-6));
  CHECK(turn.right == Approx(half - bearing).epsilon(1e-6));
  CHECK(turn.smaller() == PassingSide::kRight);
}

TEST_CASE("inside a circle the tangent turns smoothly to straight out", "[unit]") {
  const auto circles = clustered({{{0.5, 0.0}, 0.2}});
  const double outside = circles.extents(0, {0.3 - 1e-9, 0.0}, {1.0, 0.0}).left;
  const double inside = circles.extents(0, {0.3 + 1e-9, 0.0}, {1.0, 0.0}).left;
  CHECK(outside == Approx(math::kPi / 2).epsilon(1e-3));
  CHECK(inside == Approx(math::kPi / 2).epsilon(1e-3));
  CHECK(circles.extents(0, {0.4, 0.0}, {1.0, 0.0}).left == Approx(0.75 * math::kPi));
}

TEST_CASE("circles that overlap through others are passed together", "[unit]") {
  // The second and third overlap only the first; the fourth overlaps none.
  const auto circles =
      clustered({{{0.5, 0.0}, 0.1}, {{0.5, 0.19}, 0.1}, {{0.5, -0.15}, 0.1}, {{0.5, -0.5}, 0.1}});
  const Extents all = circles.extents(0, {}, {1.0, 0.0});
  CHECK(circles.extents(1, {}, {1.0, 0.0}).left == all.left);
  CHECK(circles.extents(2, {}, {1.0, 0.0}).right == all.right);
  CHECK(all.left == Approx(0.5512103).epsilon(1e-6));   // atan(0.38) + asin(0.1 / 0.53488)
  CHECK(all.right == Approx(0.4842135).epsilon(1e-6));  // atan(0.30) + asin(0.1 / 0.52202)
  CHECK(circles.extents(3, {}, {1.0, 0.0}).right > all.right);
}

TEST_CASE("a side is kept within the hysteresis and forgotten once the cluster is passed", "[unit]") {
  const Vec2 goal{1.0, 0.0};
  auto circles = clustered({{{0.5, 0.01}, 0.1}});
  circles.decideSides({}, goal, {.hysteresis = 0.2});
  REQUIRE(circles.side(0, {}, goal) == PassingSide::kRight);
  again(circles, {{{0.5, -0.04}, 0.1}});  // 2 x 0.08 rad in favour of the left
  circles.decideSides({}, goal, {.hysteresis = 0.2});
  CHECK(circles.side(0, {}, goal) == PassingSide::kRight);
  again(circles, {{{0.5, -0.06}, 0.1}});  // 2 x 0.12 rad
  circles.decideSides({}, goal, {.hysteresis = 0.2});
  CHECK(circles.side(0, {}, goal) == PassingSide::kLeft);
  circles.decideSides({0.6, 0.0}, goal, {.hysteresis = 0.2});
  CHECK(circles.side(0, {}, {1.0, -0.3}) == PassingSide::kRight);  // decided without memory
}

TEST_CASE("a side that leads out of the field is avoided while the other does not", "[unit]") {
  FieldGeometry field;
  const Vec2 p{-0.5, 0.5}, goal{0.5, 0.5};
  auto circles = clustered({{{0.0, 0.49}, 0.12}});
  circles.decideSides(p, goal, {});
  CHECK(circles.side(0, p, goal) == PassingSide::kLeft);
  circles.decideSides(p, goal, {.inside = &field, .wall_margin = 0.053});
  CHECK(circles.side(0, p, goal) == PassingSide::kRight);
  // If the circle fills the width, no side is free, and the smaller turn wins.
  auto wall = clustered({{{0.0, 0.1}, 0.7}});
  wall.decideSides(p, goal, {.inside = &field, .wall_margin = 0.053});
  CHECK(wall.side(0, p, goal) == PassingSide::kLeft);
}

}  // namespace fulbito
