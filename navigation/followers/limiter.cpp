#include "navigation/followers/limiter.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/spin_ratio.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {

Twist bodyTwist(const RobotState& state) {
  return {dot(state.velocity, math::unit(state.pose.heading)), state.angular_velocity};
}

RobotModel steady(RobotModel robot) {
  robot.yaw_acceleration = robot.motorPull() / (robot.axle_track / 2);
  return robot;
}

Twist limitTwist(const RobotModel& robot, Twist current, Twist wanted, double dt) {
  const double half_track = robot.axle_track / 2;
  const double most_turn = robot.turnAcceleration() * dt;
  const double kept = SpinRatio(robot).commandFor(current);
  const double turn = std::clamp(wanted.angular - kept, -most_turn, most_turn);
  // The share of the motors' pull that turning leaves to the speed.
  const double rest = most_turn > 0.0 ? 1.0 - std::abs(turn) / most_turn : 0.0;
  const double change = wanted.linear - current.linear;
  const bool slows = change * current.linear < 0.0;
  const double most = rest * dt * (slows ? robot.wheel_braking : robot.wheel_acceleration);
  Twist limited;
  limited.angular = kept + turn;
  limited.linear = current.linear + std::clamp(change, -most, most);
  const double max_speed = robot.maxSpeed();
  limited.angular = std::clamp(limited.angular, -max_speed / half_track, max_speed / half_track);
  const double room = std::max(0.0, max_speed - std::abs(limited.angular) * half_track);
  limited.linear = std::clamp(limited.linear, -room, room);
  return limited;
}

}  // namespace fulbito
