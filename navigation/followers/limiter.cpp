#include "navigation/followers/limiter.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/spin_ratio.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {

namespace {

struct Turn {
  double command = 0.0;  // [rad/s]
  double pulled = 0.0;   // [rad/s] the change of the yaw rate that the motors have to make
};

/// The commanded yaw rate nearest to `wanted` [rad/s] that changes the present one by at most `most`. Between
/// the commands that keep a turn and those that slow it, the motors do not pull.
Turn turnBy(const SpinRatio& ratio, const Twist& current, double wanted, double most) {
  const double sense = std::copysign(1.0, current.angular);
  const double keeps = sense * ratio.commandFor(current), slows = sense * ratio.slowingCommandFor(current);
  const double aim = sense * wanted;
  const double command = std::clamp(aim, slows - most, keeps + most);
  const double pulled = command > keeps ? command - keeps : std::min(command - slows, 0.0);
  return {sense * command, sense * pulled};
}

}  // namespace

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
  const Turn turn = turnBy(SpinRatio(robot), current, wanted.angular, most_turn);
  // The share of the motors' pull that turning leaves to the speed.
  const double rest = most_turn > 0.0 ? 1.0 - std::abs(turn.pulled) / most_turn : 0.0;
  const double change = wanted.linear - current.linear;
  const bool slows = change * current.linear < 0.0;
  const double most = rest * dt * (slows ? robot.wheel_braking : robot.wheel_acceleration);
  Twist limited;
  limited.angular = turn.command;
  limited.linear = current.linear + std::clamp(change, -most, most);
  const double max_speed = robot.maxSpeed();
  limited.angular = std::clamp(limited.angular, -max_speed / half_track, max_speed / half_track);
  const double room = std::max(0.0, max_speed - std::abs(limited.angular) * half_track);
  limited.linear = std::clamp(limited.linear, -room, room);
  return limited;
}

}  // namespace fulbito
