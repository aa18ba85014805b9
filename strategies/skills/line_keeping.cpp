#include "strategies/skills/line_keeping.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {

std::optional<Twist> keepLine(const RobotState& robot, Vec2 place, double max_speed) {
  constexpr double kFarthestOff = 0.06;   // [m]
  constexpr double kPositionGain = 9.0;   // [1/s]
  constexpr double kHeadingGain = 8.0;    // [1/s]
  constexpr double kLineGain = 6.0;       // [rad/m] turn toward the line per distance from it
  constexpr double kGreatestLean = 0.35;  // [rad] largest turn toward the line
  constexpr double kTurnFirst = 0.6;      // [rad] at larger heading errors the robot only turns
  const Vec2 off = place - robot.pose.position;
  if (std::abs(off.x) > kFarthestOff) return std::nullopt;
  // The end that is nearer to +y counts as the front.
  const bool up = math::sin(robot.pose.heading) >= 0.0;
  const double sign = up ? 1.0 : -1.0;
  const double speed = std::clamp(kPositionGain * off.y, -max_speed, max_speed);
  const double lean =
      std::clamp(kLineGain * off.x, -kGreatestLean, kGreatestLean) * (off.y >= 0.0 ? -1.0 : 1.0);
  const double error =
      math::wrapAngle(sign * math::kPi / 2 + (std::abs(off.y) > 0.01 ? lean : 0.0) - robot.pose.heading);
  const double held = std::abs(error) > kTurnFirst ? 0.0 : 1.0;
  return Twist{held * sign * speed, kHeadingGain * error};
}

}  // namespace fulbito
