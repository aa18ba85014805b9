#pragma once

#include "engine/core/math/random.hpp"

namespace fulbito {

/// Quality of a yaw-rate gyro. The defaults give the true rate.
struct GyroModel {
  double bias = 0.0;   ///< [rad/s] at the start
  double drift = 0.0;  ///< [rad/s/sqrt(s)] random walk of the bias: its standard deviation after one second
  double noise = 0.0;  ///< [rad/s] standard deviation of each reading
  double scale = 1.0;  ///< measured over true rate
};

/// A gyro on a robot of the world. Its bias walks; nobody sees it but through the readings.
class Gyro {
 public:
  Gyro(const GyroModel& model, const Rng& random) : model_(model), bias_(model.bias), random_(random) {}

  /// Mean yaw rate [rad/s] over a tick of `dt` [s] in which the robot turned by `turned` [rad].
  double read(double turned, double dt);
  /// [rad/s] its present bias
  double bias() const { return bias_; }

 private:
  GyroModel model_;
  double bias_;
  Rng random_;
};

}  // namespace fulbito
