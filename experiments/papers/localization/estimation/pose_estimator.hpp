#pragma once

#include "experiments/papers/localization/estimation/room.hpp"

namespace fulbito::localization {

/// What encoders and gyro saw in a tick.
struct InnerMotion {
  double distance = 0.0;   ///< [m] mean of both wheels
  double turn_rate = 0.0;  ///< [rad/s] of the gyro, its bias included
  double dt = 0.0;         ///< [s]
};

/// The pose after a tick of constant turning.
/// @param turned  [rad]
inline Pose2 movedBy(const Pose2& pose, double distance, double turned) {
  return {pose.position + math::unit(pose.heading + turned / 2) * distance,
          math::wrapAngle(pose.heading + turned)};
}

/// Keeps the pose of a driving robot up to date.
class PoseEstimator {
 public:
  virtual ~PoseEstimator() = default;
  /// Takes in one tick of encoders and gyro.
  virtual void advance(const InnerMotion& motion) = 0;
  /// Takes in the echoes at the present pose.
  virtual void observe(const EchoTimes& times) = 0;
  virtual Pose2 pose() const = 0;
};

/// What a robot knows when it begins to drive, and the quality of its sensors as their makers state it.
struct Knowledge {
  Room room;
  Body body;
  double axle_track = 0.3;     ///< [m]
  Pose2 pose;                  ///< of its centre
  double echo_speed = 170.0;   ///< [m/s] the calibrated constant
  double gyro_bias = 0.0;      ///< [rad/s] mean reading at standstill
  double range_sigma = 0.008;  ///< [m] noise of a range
  double cone = 0.218;         ///< [rad] half width of a sensor's cone
};

/// Encoders and gyro alone.
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
