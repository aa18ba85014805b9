#pragma once

#include "experiments/papers/localization/estimation/room.hpp"
#include "experiments/papers/localization/route_driver.hpp"
#include "fulbito/models.hpp"
#include "fulbito/sensors.hpp"

namespace fulbito::localization {

/// A robot with sensors and its driving limits.
struct Rover {
  RobotModel robot;
  SonarModel sonar;  ///< front, right, left
  EncoderModel encoders;
  GyroModel gyro;
  DriveLimits limits;
  double margin = 0.4;    ///< [m] from its centre to the walls along which it drives
  double spacing = 0.36;  ///< [m] greatest distance between stripes
};

/// The makers' specification of the sensors. The errors of a single robot are drawn from it.
struct SensorSpread {
  double range_noise = 0.008;  ///< [m] of a range
  double dropout = 0.01;       ///< share of missing echoes
  double wheel_scale = 0.01;   ///< standard deviation of each wheel's scale
  double wheel_slip = 0.004;   ///< [m/sqrt(m)] of each wheel
  double gyro_bias = 0.0087;   ///< [rad/s] standard deviation of the bias at the start
  double gyro_drift = 5e-5;    ///< [rad/s/sqrt(s)]
  double gyro_noise = 0.0035;  ///< [rad/s] of a reading
  double gyro_scale = 0.005;   ///< standard deviation of the gyro's scale
};

/// A vacuum cleaning robot of 0.44 x 0.40 m and 12 kg that drives 0.3 m/s.
Rover cleaningRobot();

/// A soccer robot of 7.5 cm with the same kind of sensors, made for short ranges; it drives 0.15 m/s.
Rover smallRobot();

/// The robot with errors drawn from `spread`.
Rover withErrors(Rover rover, const SensorSpread& spread, Rng& random);

inline Body bodyOf(const Rover& rover) { return {rover.robot.length, rover.robot.width}; }

}  // namespace fulbito::localization
