#include "engine/sim/drive.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace fulbito {

SpinRatio::SpinRatio(const RobotModel& robot) {
  if (!(robot.spin_slow_speed > 0.0) || !(robot.spin_fast_speed > robot.spin_slow_speed)) return;
  from_ = robot.spin_slow_speed;
  span_ = robot.spin_fast_speed - from_;
  slow_ = robot.spin_slow_ratio;
  slope_ = (robot.spin_fast_ratio - slow_) / span_;
}

Drive::Drive(const RobotModel& robot, double step_period, double command_step)
    : law_(robot, step_period),
      spin_ratio_(robot),
      max_wheel_speed_(robot.max_wheel_speed),
      command_step_(std::max(command_step, 0.0)),
      per_command_step_(command_step > 0.0 ? 1.0 / command_step : 0.0),
      radius_(robot.wheel_radius),
      half_track_(robot.axle_track / 2),
      per_radius_(1.0 / robot.wheel_radius),
      max_grip_(robot.longitudinal_grip * step_period),
      max_lateral_(robot.lateral_grip * step_period) {}

double Drive::rimTarget(double wheel_speed) const {
  if (std::isnan(wheel_speed)) return 0.0;
  const double limited = std::clamp(wheel_speed, -max_wheel_speed_, max_wheel_speed_);
  if (command_step_ == 0.0) return limited * radius_;
  // Round through an integer: without SSE 4.1, std::round is a function call that costs more than the rest.
  const auto steps = static_cast<std::int64_t>(limited * per_command_step_ + std::copysign(0.5, limited));
  return static_cast<double>(steps) * command_step_ * radius_;
}

// What tyres that scrub leave of half the difference of the commanded rims' speeds.
double Drive::scrubbedTurn(double common, double half_difference) const {
  if (spin_ratio_.isOne()) return half_difference;
  // None beside a wheel that stands still.
  const double in_place = std::max(std::abs(half_difference) - std::abs(common), 0.0);
  const double scrubbed = (spin_ratio_.at(std::abs(half_difference)) - 1.0) * in_place;
  return half_difference + std::copysign(1.0, half_difference) * scrubbed;
}

void Drive::setCommand(WheelSpeeds command) {
  using Bits = std::array<std::uint64_t, 2>;  // as 0 and -0 ask for rims that differ
  if (std::bit_cast<Bits>(command) == std::bit_cast<Bits>(command_)) return;
  command_ = command;
  const double left = rimTarget(command.left), right = rimTarget(command.right);
  const double common = (left + right) / 2, turn = scrubbedTurn(common, (right - left) / 2);
  target_ = law_.reached({common - turn, common + turn});
}

// The largest force from the floor to a wheel. If the motor pulls more, the rim spins.
double Drive::slippingLimit(double pull, double target, double ground, double& rim, bool& slips) const {
  if (std::abs(pull) <= max_grip_) {
    slips = false;
    return law_.limit();
  }
  if (!slips) rim = ground;
  slips = true;
  rim += std::clamp(target - rim, -law_.limit(), law_.limit());
  return max_grip_;
}

RimSpeeds Drive::slippingPulls(RimSpeeds ground, RimSpeeds pulls) {
  const double left = slippingLimit(pulls.left, target_.left, ground.left, rim_.left, left_slips_);
  const double right = slippingLimit(pulls.right, target_.right, ground.right, rim_.right, right_slips_);
  return law_.pulls(ground, target_, {left, right});
}

}  // namespace fulbito
