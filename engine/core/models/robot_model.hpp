#pragma once

#include <string>

#include "engine/core/base/result.hpp"
#include "engine/core/base/values.hpp"

namespace fulbito {

/// Differential-drive robot: a rectangular body on two wheels. Motors of limited force make the rim speeds
/// follow the commands, and the grip on the floor is limited along and across the wheels. The body couples
/// the wheels: a pull at one affects the other (docs/models.md). Defaults: a 7.5 cm league robot.
struct RobotModel {
  std::string name = "vsss";
  double length = 0.075;            ///< [m] body along x
  double width = 0.075;             ///< [m] body along y
  double mass = 0.15;               ///< [kg]
  double wheel_radius = 0.026;      ///< [m]
  double axle_track = 0.0775;       ///< [m] between wheel centres
  double max_wheel_speed = 46.08;   ///< [rad/s] faster commands are clamped
  double wheel_acceleration = 7.0;  ///< [m/s^2] driving straight, both motors accelerating
  double wheel_braking = 7.0;       ///< [m/s^2] driving straight, both motors braking
  double yaw_acceleration = 0.0;    ///< [rad/s^2] turning in place; 0 = from mass and shape
  double rolling_drag = 0.0;        ///< [m/s^2] that the motors overcome in addition to `wheel_acceleration`
  double longitudinal_grip = 9.0;   ///< [m/s^2] Coulomb limit along the wheels
  double lateral_grip = 6.0;        ///< [m/s^2] Coulomb limit across the wheels
  double spin_slow_speed = 0.0;  ///< [m/s] rim speed of the first measured spin in place; 0 = ideal spinning
  double spin_slow_ratio = 1.0;  ///< measured over ideal yaw rate at `spin_slow_speed` and below
  double spin_fast_speed = 0.0;  ///< [m/s] rim speed of the second measured spin
  double spin_fast_ratio = 1.0;  ///< the same at `spin_fast_speed` and above; linear between
  double friction = 0.2;         ///< of the body against robots, walls and obstacles
  double restitution = 0.1;      ///< of the body against robots, walls and obstacles

  double inertia() const;    ///< [kg m^2] of the body's rectangle about its centre
  double motorPull() const;  ///< [m/s^2] largest force of both motors over the mass, drag compensated
  double turnShare() const;  ///< rim acceleration when turning in place, over `motorPull`
  double turnAcceleration()
      const;  ///< [rad/s^2] turning in place: `yaw_acceleration`, or from mass and shape
  double maxSpeed() const { return max_wheel_speed * wheel_radius; }  ///< [m/s]
  double circumradius() const;                                        ///< [m] of the body's rectangle
};

/// Checks ranges and consistency; the error names the key.
Result<void> validate(const RobotModel& robot);

/// Wheel speeds for the twist, without limits.
WheelSpeeds inverseKinematics(const RobotModel& robot, Twist twist);
/// Twist for the wheel speeds, without slip.
Twist forwardKinematics(const RobotModel& robot, WheelSpeeds wheels);
/// Clamps each wheel to `max_wheel_speed`, without scaling the other; NaN becomes 0.
WheelSpeeds saturate(const RobotModel& robot, WheelSpeeds wheels);
/// Rounds both wheels to multiples of `step` [rad/s]; step <= 0 changes nothing.
WheelSpeeds roundedTo(WheelSpeeds wheels, double step);

/// State of `robot` one tick of `dt` [s] later if its wheels follow `command` by the `DriveLaw`, without
/// slip.
RobotState rolledForward(const RobotModel& model, RobotState robot, WheelSpeeds command, double dt);

}  // namespace fulbito
