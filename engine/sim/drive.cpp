#include "engine/sim/drive.hpp"

#include <algorithm>
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
    : spin_ratio_(robot),
      max_wheel_speed_(robot.max_wheel_speed),
      command_step_(std::max(command_step, 0.0)),
      per_command_step_(command_step > 0.0 ? 1.0 / command_step : 0.0),
      radius_(robot.wheel_radius),
      half_track_(robot.axle_track / 2),
      per_radius_(1.0 / robot.wheel_radius),
      max_gain_(robot.wheel_acceleration * step_period),
      max_loss_(robot.wheel_braking * step_period),
      max_grip_(robot.longitudinal_grip * step_period),
      max_lateral_(robot.lateral_grip * step_period) {}

double Drive::rimTarget(double wheel_speed) const {
  if (std::isnan(wheel_speed)) return 0.0;
  const double limited = std::clamp(wheel_speed, -max_wheel_speed_, max_wheel_speed_);
  if (command_step_ == 0.0) return limited * radius_;
  // Through an integer: without SSE 4.1, std::round is a call that costs more than the rest.
  const auto steps = static_cast<std::int64_t>(limited * per_command_step_ + std::copysign(0.5, limited));
  return static_cast<double>(steps) * command_step_ * radius_;
}

void Drive::setCommand(WheelSpeeds command) {
  const double left = rimTarget(command.left), right = rimTarget(command.right);
  const double half_difference = (right - left) / 2;
  const double turn = half_difference * spin_ratio_.at(std::abs(half_difference));
  left_.target = (left + right) / 2 - turn;
  right_.target = (left + right) / 2 + turn;
}

double Drive::pull(Wheel& wheel, double ground) const {
  const bool slows = wheel.target * ground < 0.0 || std::abs(wheel.target) < std::abs(ground);
  const double limit = slows ? max_loss_ : max_gain_;
  const double demand = std::clamp(wheel.target - ground, -limit, limit);
  if (std::abs(demand) <= max_grip_) {
    wheel.slips = false;
    return demand;
  }
  if (!wheel.slips) wheel.rim = ground;
  wheel.slips = true;
  wheel.rim += std::clamp(wheel.target - wheel.rim, -limit, limit);
  return std::copysign(max_grip_, demand);
}

BodyMotion Drive::step(const BodyMotion& motion) {
  const double turn = motion.yaw * half_track_;
  const double left = pull(left_, motion.forward - turn);
  const double right = pull(right_, motion.forward + turn);
  return {(left + right) / 2, -std::clamp(motion.sideways, -max_lateral_, max_lateral_),
          (right - left) / (2 * half_track_)};
}

WheelSpeeds Drive::encoders(double forward, double yaw) const {
  const double turn = yaw * half_track_;
  const double left = left_.slips ? left_.rim : forward - turn;
  const double right = right_.slips ? right_.rim : forward + turn;
  return {left * per_radius_, right * per_radius_};
}

}  // namespace fulbito
