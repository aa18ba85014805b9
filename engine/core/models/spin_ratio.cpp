#include "engine/core/models/spin_ratio.hpp"

#include <cmath>

namespace fulbito {

SpinRatio::SpinRatio(const RobotModel& robot)
    : half_track_(robot.axle_track / 2),
      per_play_(robot.wheel_width > 0.0 ? robot.axle_track / robot.wheel_width : 1.0) {
  if (!(robot.spin_slow_speed > 0.0) || !(robot.spin_fast_speed > robot.spin_slow_speed)) return;
  from_ = robot.spin_slow_speed;
  span_ = robot.spin_fast_speed - from_;
  slow_ = robot.spin_slow_ratio;
  slope_ = (robot.spin_fast_ratio - slow_) / span_;
}

double SpinRatio::commandFor(const Twist& motion) const {
  if (isOne()) return motion.angular;
  const double wanted = std::abs(motion.angular) * half_track_;
  const double driven = std::abs(motion.linear) * per_play_;
  double turn = wanted;
  // Each round leaves a quarter of the error, since the ratios are near 1.
  for (int round = 0; round < 4; ++round) turn = wanted - (at(turn) - 1.0) * std::max(turn - driven, 0.0);
  return std::copysign(turn / half_track_, motion.angular);
}

}  // namespace fulbito
