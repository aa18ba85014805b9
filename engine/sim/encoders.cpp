#include <cmath>

#include "fulbito/detail/math.hpp"
#include "fulbito/sensors.hpp"

namespace fulbito {
namespace {

/// Distance [m] that the robot's centre moved along its body: a chord along the mean heading.
double forwardTravel(const RobotState& before, const RobotState& after, double turned) {
  return dot(after.pose.position - before.pose.position, math::unit(before.pose.heading + turned / 2));
}

}  // namespace

WheelEncoders::WheelEncoders(const EncoderModel& model, const RobotModel& robot, const Rng& random)
    : model_(model),
      radius_(robot.wheel_radius),
      half_track_(robot.axle_track / 2),
      metres_per_count_(2 * math::kPi * robot.wheel_radius / model.counts_per_turn),
      random_(random) {}

EncoderCounts WheelEncoders::read(const RobotState& before, const RobotState& after, double dt) {
  const double turned = math::wrapAngle(after.pose.heading - before.pose.heading);
  const double forward = forwardTravel(before, after, turned);
  // Speed of a spinning wheel's rim relative to the floor, at the end of the tick.
  const double speed = dot(after.velocity, math::unit(after.pose.heading));
  const double turn_speed = after.angular_velocity * half_track_;
  const double left_spin = after.wheels.left * radius_ - (speed - turn_speed);
  const double right_spin = after.wheels.right * radius_ - (speed + turn_speed);
  return {count(forward - turned * half_track_ + left_spin * dt, model_.left_scale, left_rest_),
          count(forward + turned * half_track_ + right_spin * dt, model_.right_scale, right_rest_)};
}

std::int64_t WheelEncoders::count(double travel, double scale, double& rest) {
  const double noise =
      travel == 0.0 ? 0.0 : random_.normal(0.0, model_.slip_noise * std::sqrt(std::abs(travel)));
  rest += travel * scale + noise;
  const auto counts = static_cast<std::int64_t>(std::floor(rest / metres_per_count_));
  rest -= static_cast<double>(counts) * metres_per_count_;
  return counts;
}

}  // namespace fulbito
