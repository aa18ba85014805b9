#include "strategies/skills/quick_twist.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {

RobotCommand quickTwist(const RobotModel& model, const RobotState& robot, Twist wanted, double dt) {
  const double most_turn = model.turnAcceleration() * dt, half_track = model.axle_track / 2;
  const double turn = std::clamp(wanted.angular - robot.angular_velocity, -most_turn, most_turn);
  const double left = most_turn > 0.0 ? 1.0 - std::abs(turn) / most_turn : 0.0;  // share for the speed
  const double speed = dot(robot.velocity, math::unit(robot.pose.heading));
  const bool brakes = (wanted.linear - speed) * speed < 0.0;
  const double rate =
      std::min(brakes ? model.wheel_braking : model.wheel_acceleration, model.longitudinal_grip);
  const double step = rate * dt * left;
  Twist twist;
  twist.angular = std::clamp(robot.angular_velocity + turn, -model.maxSpeed() / half_track,
                             model.maxSpeed() / half_track);
  const double room = std::max(0.0, model.maxSpeed() - std::abs(twist.angular) * half_track);
  twist.linear = std::clamp(speed + std::clamp(wanted.linear - speed, -step, step), -room, room);
  return RobotCommand::byWheels(inverseKinematics(model, twist));
}

}  // namespace fulbito
