#include <algorithm>
#include <cmath>

#include "engine/core/models/drive_law.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

double RobotModel::circumradius() const { return 0.5 * std::sqrt(length * length + width * width); }

double RobotModel::inertia() const { return mass * (length * length + width * width) / 12; }

double RobotModel::braking() const { return std::min(wheel_braking, longitudinal_grip + rolling_drag); }

double RobotModel::motorPull() const {
  return std::max(wheel_acceleration + rolling_drag, wheel_braking - rolling_drag);
}

// Motors that pull F each give the mass 2 F / m, and against each other the rims track^2 F / (2 I).
double RobotModel::turnShare() const {
  const double half_track = axle_track / 2;
  if (yaw_acceleration > 0.0) return yaw_acceleration * half_track / std::max(motorPull(), 1e-9);
  return mass * half_track * half_track / inertia();
}

double RobotModel::turnAcceleration() const { return turnShare() * motorPull() / (axle_track / 2); }

WheelSpeeds inverseKinematics(const RobotModel& robot, Twist twist) {
  const double turn = twist.angular * robot.axle_track / 2;
  return {(twist.linear - turn) / robot.wheel_radius, (twist.linear + turn) / robot.wheel_radius};
}

Twist forwardKinematics(const RobotModel& robot, WheelSpeeds wheels) {
  const double left = wheels.left * robot.wheel_radius, right = wheels.right * robot.wheel_radius;
  return {(left + right) / 2, (right - left) / robot.axle_track};
}

WheelSpeeds saturate(const RobotModel& robot, WheelSpeeds wheels) {
  const double limit = robot.max_wheel_speed;
  const auto clamped = [limit](double w) { return std::isnan(w) ? 0.0 : std::clamp(w, -limit, limit); };
  return {clamped(wheels.left), clamped(wheels.right)};
}

WheelSpeeds wheelsOverGround(const RobotModel& robot, Twist twist) {
  const double turn = twist.angular * robot.axle_track / 2;
  const DriveLaw law(robot, 1.0);  // slip does not depend on the time step
  const RimSpeeds rims = law.commandFor({twist.linear - turn, twist.linear + turn});
  return saturate(robot, {rims.left / robot.wheel_radius, rims.right / robot.wheel_radius});
}

WheelSpeeds roundedTo(WheelSpeeds wheels, double step) {
  if (!(step > 0.0)) return wheels;
  const auto rounded = [step](double w) {
    const double multiple = std::round(w / step) * step + 0.0;  // no -0, which integers do not have
    return std::isfinite(multiple) ? multiple : w;  // far beyond any wheel, the quotient overflows
  };
  return {rounded(wheels.left), rounded(wheels.right)};
}

RobotState rolledForward(const RobotModel& model, RobotState robot, WheelSpeeds command, double dt) {
  const DriveLaw law(model, dt);
  const double radius = model.wheel_radius;
  const RimSpeeds ground{robot.wheels.left * radius, robot.wheels.right * radius};
  const RimSpeeds target = law.reached({command.left * radius, command.right * radius});
  const RimSpeeds change = law.change(ground, law.pulls(ground, target, {law.limit(), law.limit()}));
  const WheelSpeeds before = robot.wheels;
  robot.wheels = {(ground.left + change.left) / radius, (ground.right + change.right) / radius};
  const Twist twist = forwardKinematics(
      model, {(before.left + robot.wheels.left) / 2, (before.right + robot.wheels.right) / 2});
  const double middle = robot.pose.heading + twist.angular * dt / 2;
  robot.pose.position += math::unit(middle) * (twist.linear * dt);
  robot.pose.heading = math::wrapAngle(robot.pose.heading + twist.angular * dt);
  const Twist end = forwardKinematics(model, robot.wheels);
  robot.velocity = math::unit(robot.pose.heading) * end.linear;
  robot.angular_velocity = end.angular;
  return robot;
}

}  // namespace fulbito
