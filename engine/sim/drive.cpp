#include "engine/sim/drive.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {

double spinRatio(const RobotModel& robot, double rim_speed) {
  const double slow = robot.spin_slow_speed, fast = robot.spin_fast_speed;
  if (!(slow > 0.0) || !(fast > slow)) return 1.0;
  const double share = std::clamp((rim_speed - slow) / (fast - slow), 0.0, 1.0);
  return robot.spin_slow_ratio + (robot.spin_fast_ratio - robot.spin_slow_ratio) * share;
}

Drive::Drive(const RobotModel& robot, double step_period, double command_step)
    : model_(robot),
      command_step_(command_step),
      half_track_(robot.axle_track / 2),
      per_radius_(1.0 / robot.wheel_radius),
      max_gain_(robot.wheel_acceleration * step_period),
      max_loss_(robot.wheel_braking * step_period),
      max_grip_(robot.longitudinal_grip * step_period),
      max_lateral_(robot.lateral_grip * step_period) {}

void Drive::setCommand(WheelSpeeds command) {
  if (command.left == command_.left && command.right == command_.right) return;
  command_ = command;
  const WheelSpeeds wheels = roundedTo(saturate(model_, command), command_step_);
  const double left = wheels.left * model_.wheel_radius, right = wheels.right * model_.wheel_radius;
  const double half_difference = (right - left) / 2;
  const double turn = half_difference * spinRatio(model_, std::abs(half_difference));
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
