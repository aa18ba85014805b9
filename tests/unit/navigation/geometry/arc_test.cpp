#include "fulbito/detail/arc.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kDegree = math::kPi / 180.0;

void checkPose(const Pose2& pose, double x, double y, double heading) {
  CHECK(pose.position.x == Approx(x).margin(1e-12));
  CHECK(pose.position.y == Approx(y).margin(1e-12));
  CHECK(std::abs(math::wrapAngle(pose.heading - heading)) < 1e-12);
}

TEST_CASE("arc: a quarter circle to either side, a line and a small turn end where geometry says") {
  const Pose2 start{{1.0, 2.0}, math::kPi / 2};
  checkPose(endOf({start, 0.5, math::kPi}), -1.0, 4.0, math::kPi);
  checkPose(endOf({start, -0.5, math::kPi}), 3.0, 4.0, 0.0);
  checkPose(endOf({start, 0.0, 3.0}), 1.0, 5.0, math::kPi / 2);
  const Arc slight{{{0.0, 0.0}, 0.0}, 1e-9, 1.0};
  CHECK(endOf(slight).position.y == Approx(0.5e-9));
  // A full circle returns to its start.
  checkPose(endOf({start, 1.0, 2 * math::kPi}), 1.0, 2.0, math::kPi / 2);
}

TEST_CASE("arc: both sides of the switch to the series of small turns agree") {
  const Pose2 start{{0.0, 0.0}, 0.3};
  const Vec2 below = endOf({start, 1.99999e-4, 1.0}).position,
             above = endOf({start, 2.00001e-4, 1.0}).position;
  CHECK(norm(below - above) < 1.1e-9);
}

TEST_CASE("arc: the one through a point has the radius and turn of the paper's corrected Table 1") {
  const Arc arc = arcThrough({{0.0, 0.0}, math::kPi / 2}, {5.0, 4.0});
  CHECK(-1.0 / arc.curvature == Approx(4.1));
  CHECK(-arc.turn() / kDegree == Approx(102.68).margin(0.005));
  CHECK(arc.length == Approx(7.348).margin(0.0005));
  checkPose(endOf(arc), 5.0, 4.0, math::kPi / 2 + arc.turn());
}

TEST_CASE("arc: through a point aside behind it turns more than half a circle, straight behind is infinite") {
  const Pose2 start{{0.0, 0.0}, 0.0};
  const Arc behind = arcThrough(start, {-1.0, 0.5});
  CHECK(behind.turn() > math::kPi);
  checkPose(endOf(behind), -1.0, 0.5, behind.turn());
  CHECK(std::isinf(arcThrough(start, {-1.0, 0.0}).length));
  CHECK(arcThrough(start, {2.0, 0.0}).length == 2.0);
  CHECK(arcThrough(start, {0.0, 0.0}).length == 0.0);
}

}  // namespace
}  // namespace fulbito
