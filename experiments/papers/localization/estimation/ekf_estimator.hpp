#pragma once

#include <array>
#include <cstddef>

#include "experiments/papers/localization/estimation/pose_estimator.hpp"

namespace fulbito::localization {

/// Standard deviations of the sensors and of the start, for the filter.
struct EkfSettings {
  std::array<double, 9> start{};  ///< covariance of x [m], y [m] and echo speed [m/s], row by row
  double start_heading = 0.0075;  ///< [rad]
  double start_bias = 0.0008;     ///< [rad/s]
  double encoder_scale = 0.01;    ///< relative error of each wheel
  double slip = 0.004;            ///< [m/sqrt(m)] of each wheel
  double gyro_noise = 0.0035;     ///< [rad/s] of a reading
  double gyro_drift = 5e-5;       ///< [rad/s/sqrt(s)]
  double gyro_scale = 0.005;      ///< relative error of turns
  double gate = 3.0;              ///< sigmas; echoes with a larger difference are not used
};

/// An extended Kalman filter over the pose, the gyro's bias, the constant from echo time to distance, and the
/// encoders' scale. Each echo of a wall near the sensor's axis is one measurement.
class EkfEstimator : public PoseEstimator {
 public:
  static constexpr std::size_t kStates = 6;  ///< x, y, heading, gyro bias, constant, scale

  EkfEstimator(const Knowledge& known, const EkfSettings& settings);

  void advance(const InnerMotion& motion) override;
  void observe(const EchoTimes& times) override;
  Pose2 pose() const override { return {{state_[0], state_[1]}, state_[2]}; }

  /// [m/s] present estimate of the constant
  double echoSpeed() const { return state_[4]; }
  /// Squared error of the pose in units of its covariance (NEES): 3 on average if the filter is consistent.
  double squaredError(const Pose2& truth) const;

 private:
  void addTurnErrors(double turned, double distance, double dt);
  void update(Beam beam, double time);

  Knowledge known_;
  EkfSettings settings_;
  std::array<double, kStates> state_;
  std::array<double, kStates * kStates> covariance_{};  ///< row by row
};

}  // namespace fulbito::localization
