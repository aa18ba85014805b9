#include "strategies/skills/ball_posture.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {

BallSide sideOfBall(const RobotState& robot, Vec2 ball, Vec2 direction) {
  const Vec2 from = intoFrame(direction, robot.pose.position - ball);
  BallSide side{-from.x, from.y, 0.0, false};
  const double error = math::wrapAngle(robot.pose.heading - math::angleOf(direction));
  side.backward = std::abs(error) > math::kPi / 2;
  side.misalignment = side.backward ? math::wrapAngle(error + math::kPi) : error;
  return side;
}

BallApproach approachBall(const RobotState& robot, Vec2 ball, Vec2 direction, bool was_round,
                          const PostureSettings& settings) {
  const Vec2 from = intoFrame(direction, robot.pose.position - ball);
  BallApproach approach;
  // A robot counts as on the wrong side until a robot behind the ball just has room. While it drives round,
  // the limit is a bit farther back (hysteresis).
  approach.round = -from.x < (was_round ? 0.06 : 0.02);
  approach.go_to.position = ball - direction * (approach.round ? settings.detour : settings.standoff);
  approach.go_to.heading = math::angleOf(direction);
  approach.go_to.avoid_ball = approach.round;
  return approach;
}

bool isLinedUp(const BallSide& side, bool was_lined_up, const PostureSettings& settings) {
  const double aside = was_lined_up ? settings.release_aside : settings.line_aside;
  const double heading = was_lined_up ? 2.0 * settings.line_heading : settings.line_heading;
  return side.behind > 0.0 && side.behind < settings.line_behind && std::abs(side.aside) < aside &&
         std::abs(side.misalignment) < heading;
}

Twist strike(const RobotState& robot, Vec2 ball, Vec2 direction, double speed) {
  // Holding the heading carries a ball farther than steering at the ball (docs/skills.md). The small lateral
  // gain still reduces the offset.
  constexpr double kHeadingGain = 8.0;  // [1/s]
  constexpr double kAsideGain = 40.0;   // [rad/(s m)]
  const BallSide side = sideOfBall(robot, ball, direction);
  const double turn = -kHeadingGain * side.misalignment - kAsideGain * side.aside;
  return {side.backward ? -speed : speed, turn};
}

}  // namespace fulbito
