#include "strategies/skills/unsticking.hpp"

#include <cmath>

namespace fulbito {

std::optional<Twist> Unsticking::update(const RobotState& robot, bool meant, double dt) {
  constexpr double kStill = 0.03, kTurning = 1.0;        // [m/s], [rad/s]
  constexpr double kPatience = 0.8, kBackingOff = 0.25;  // [s]
  constexpr double kSpeed = 0.5, kWiggle = 3.0;          // [m/s], [rad/s]
  if (left_ > 0.0) {
    left_ -= dt;
    return Twist{speed_, kWiggle};
  }
  const bool still = norm(robot.velocity) < kStill && std::abs(robot.angular_velocity) < kTurning;
  held_ = meant && still ? held_ + dt : 0.0;
  if (held_ < kPatience) return std::nullopt;
  held_ = 0.0;
  left_ = kBackingOff;
  // Drive opposite to the wheels' present direction.
  speed_ = robot.wheels.left + robot.wheels.right > 0.0 ? -kSpeed : kSpeed;
  return Twist{speed_, kWiggle};
}

}  // namespace fulbito
