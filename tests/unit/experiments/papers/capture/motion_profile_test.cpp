#include "experiments/papers/capture/motion_profile.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::capture {

TEST_CASE("a phase of growing speed and constant curvature is an arc", "[unit]") {
  MotionProfile motion;
  motion.append({2.0, {0.0, 0.0}, {1.0, 0.5}});  // 1 m on a radius of 2 m
  const Pose2 end = motion.end().pose;
  CHECK(end.heading == Approx(0.5));
  CHECK(end.position.x == Approx(2 * math::sin(0.5)));
  CHECK(end.position.y == Approx(2 * (1 - math::cos(0.5))));
  CHECK(motion.at(1.0).pose.heading == Approx(0.125));
  CHECK(motion.at(1.0).twist.linear == Approx(0.5));
}

TEST_CASE("a phase of falling curvature turns by half its first yaw rate times its time", "[unit]") {
  MotionProfile motion;
  motion.append({1.0, {1.0, 0.4}, {1.0, 0.0}});
  const Pose2 end = motion.end().pose;
  CHECK(end.heading == Approx(0.2));
  // y = integral of sin(0.4 t - 0.2 t^2), by Simpson's rule.
  double y = 0.0;
  constexpr int kSteps = 200;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps,
                 weight = i == 0 || i == kSteps ? 1 : (i % 2 == 1 ? 4 : 2);
    y += weight * math::sin(0.4 * t - 0.2 * t * t) / (3.0 * kSteps);
  }
  CHECK(end.position.y == Approx(y).epsilon(1e-3));
}

TEST_CASE("a motion is continuous across its phases and stays within its time", "[unit]") {
  MotionProfile motion({{1.0, 2.0}, 3.0});
  CHECK(motion.at(5.0).pose.position == Vec2{1.0, 2.0});
  motion.append({1.0, {}, {0.3, 0.3}});
  motion.append({0.5, {0.3, 0.3}, {0.3, 0.0}});
  motion.append({2.0, {0.3, 0.0}, {0.1, 0.0}});
  CHECK(motion.duration() == Approx(3.5));
  for (double t = 0.0; t < 3.5; t += 0.05) {
    const MotionState now = motion.at(t), next = motion.at(t + 1e-6);
    CHECK(distance(now.pose.position, next.pose.position) < 1e-6);
    CHECK(std::abs(math::wrapAngle(now.pose.heading - next.pose.heading)) < 1e-6);
  }
  CHECK(motion.at(-1.0).pose.position == Vec2{1.0, 2.0});
  CHECK(motion.at(9.0).pose.position == motion.end().pose.position);
  CHECK(motion.end().twist.linear == Approx(0.1));
}

}  // namespace fulbito::capture
