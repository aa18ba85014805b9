#include "engine/core/models/spin_ratio.hpp"

#include <cmath>

namespace fulbito {

SpinRatio::SpinRatio(const RobotModel& robot)
    : half_track_(robot.axle_track / 2),
      edges_(robot.wheel_width / robot.axle_track),
      per_play_(robot.wheel_width > 0.0 ? robot.axle_track / robot.wheel_width : 1.0) {
  if (!(robot.spin_slow_speed > 0.0) || !(robot.spin_fast_speed > robot.spin_slow_speed)) return;
  from_ = robot.spin_slow_speed;
  span_ = robot.spin_fast_speed - from_;
  slow_ = robot.spin_slow_ratio;
  slope_ = (robot.spin_fast_ratio - slow_) / span_;
}

// The command [m/s] of half the rims' difference that makes the rims turn at `turn` [m/s], where the wheels
// roll on edges `outer_edge` times the axle track apart.
double SpinRatio::commandForRims(double turn, double outer_edge, const Twist& motion) const {
  const double driven = std::abs(motion.linear) * per_play_;
  // Up to this turn nothing scrubs, as on most ways.
  if (isOne() || turn <= driven) return turn;
  double command = turn;
  // Each round leaves a small share of the error, since the ratios are near 1.
  for (int round = 0; round < 4; ++round)
    command = turn - (at(command) * outer_edge - 1.0) * std::max(command - driven, 0.0);
  return command;
}

double SpinRatio::commandFor(const Twist& motion) const {
  const double turn = std::abs(motion.angular) * half_track_;
  return std::copysign(commandForRims(turn, 1.0, motion) / half_track_, motion.angular);
}

double SpinRatio::slowingCommandFor(const Twist& motion) const {
  const double inner = std::abs(motion.angular) * half_track_ * (1.0 - edges_);
  return std::copysign(commandForRims(inner, 1.0 + edges_, motion) / half_track_, motion.angular);
}

}  // namespace fulbito
