#pragma once

#include "experiments/papers/localization/estimation/room.hpp"

namespace fulbito::localization {

/// Readings of encoders and gyro in one tick.
struct InnerMotion {
  double distance = 0.0;   ///< [m] mean of both wheels
  double turn_rate = 0.0;  ///< [rad/s] of the gyro, including its bias
  double dt = 0.0;         ///< [s]
};

/// The pose after a tick with a constant turn rate.
/// @param turned  [rad] turn in the tick
inline Pose2 movedBy(const Pose2& pose, double distance, double turned) {
  return {pose.position + math::unit(pose.heading + turned / 2) * distance,
          math::wrapAngle(pose.heading + turned)};
}

/// Estimates the pose of a driving robot.
class PoseEstimator {
 public:
  virtual ~PoseEstimator() = default;
  /// Processes one tick of encoders and gyro.
  virtual void advance(const InnerMotion& motion) = 0;
  /// Processes the echoes at the present pose.
  virtual void observe(const EchoTimes& times) = 0;
  virtual Pose2 pose() const = 0;
};

/// A robot's knowledge when it begins to drive, with the quality of its sensors as specified by their makers.
struct Knowledge {
  Room room;
  Body body;
  double axle_track = 0.3;     ///< [m]
  Pose2 pose;                  ///< pose of its centre
  double echo_speed = 170.0;   ///< [m/s] the calibrated constant
  double gyro_bias = 0.0;      ///< [rad/s] mean reading at standstill
  double range_sigma = 0.008;  ///< [m] noise of a range
  double cone = 0.218;         ///< [rad] half width of a sensor's cone
};

/// Uses encoders and gyro only.
class DeadReckoning : public PoseEstimator {
 public:
  explicit DeadReckoning(const Knowledge& known) : pose_(known.pose), bias_(known.gyro_bias) {}

  void advance(const InnerMotion& motion) override {
    pose_ = movedBy(pose_, motion.distance, (motion.turn_rate - bias_) * motion.dt);
  }
  void observe(const EchoTimes&) override {}
  Pose2 pose() const override { return pose_; }

 private:
  Pose2 pose_;
  double bias_;
};

}  // namespace fulbito::localization
