#include "engine/sim/drive.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace fulbito {

namespace {

// [m/s^2] load on the wheels: two thirds of the weight, as two supports bear the rest
constexpr double kWheelsLoad = 9.81 * 2.0 / 3.0;

}  // namespace

Drive::Drive(const RobotModel& robot, double step_period, double command_step)
    : law_(robot, step_period),
      tilt_(robot, step_period),
      spin_ratio_(robot),
      max_wheel_speed_(robot.max_wheel_speed),
      command_step_(std::max(command_step, 0.0)),
      per_command_step_(command_step > 0.0 ? 1.0 / command_step : 0.0),
      radius_(robot.wheel_radius),
      half_track_(robot.axle_track / 2),
      per_radius_(1.0 / robot.wheel_radius),
      max_grip_(robot.longitudinal_grip * step_period),
      max_lateral_(robot.lateral_grip * step_period),
      load_shift_(robot.load_shift * robot.mass_height / (kWheelsLoad * robot.axle_track / 2)),
      outer_edge_(1.0 + robot.wheel_width / robot.axle_track),
      per_play_(robot.wheel_width > 0.0 ? robot.axle_track / robot.wheel_width : 1.0) {}

double Drive::rimTarget(double wheel_speed) const {
  if (std::isnan(wheel_speed)) return 0.0;
  const double limited = std::clamp(wheel_speed, -max_wheel_speed_, max_wheel_speed_);
  if (command_step_ == 0.0) return limited * radius_;
  // Round through an integer: without SSE 4.1, std::round is a function call that costs more than the rest.
  const auto steps = static_cast<std::int64_t>(limited * per_command_step_ + std::copysign(0.5, limited));
  return static_cast<double>(steps) * command_step_ * radius_;
}

// Half the difference of the rims' speeds after the tyres' scrubbing. Wheels that spin the body up roll on
// their outer edges. Where the measured spin is faster, they roll nearer to the inner edges.
double Drive::scrubbedTurn(double common, double half_difference) const {
  if (spin_ratio_.isOne()) return half_difference;
  // Driving forward takes away from the part of the turn that counts as a turn in place.
  const double turn = std::abs(half_difference);
  const double in_place = std::max(turn - std::abs(common) * per_play_, 0.0);
  const double scrubbed = (spin_ratio_.at(turn) * outer_edge_ - 1.0) * in_place;
  return half_difference + std::copysign(1.0, half_difference) * scrubbed;
}

void Drive::setCommand(WheelSpeeds command) {
  using Bits = std::array<std::uint64_t, 2>;  // compares bits, as 0 and -0 give different rims
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

BodyMotion Drive::tiltedStep(const BodyMotion& motion, RimSpeeds ground) {
  const Tilt::Change change = tilt_.step(ground, target_);
  const double lateral = max_lateral_ * change.lateral_grip;
  left_slips_ = right_slips_ = false;
  return {change.forward, -std::clamp(motion.sideways, -lateral, lateral), change.turn / half_track_};
}

}  // namespace fulbito
