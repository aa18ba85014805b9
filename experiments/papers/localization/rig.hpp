#pragma once

#include <cstdint>

#include "experiments/papers/localization/estimation/pose_estimator.hpp"
#include "experiments/papers/localization/rover.hpp"
#include "fulbito/sensors.hpp"
#include "fulbito/world.hpp"

namespace fulbito::localization {

/// Control ticks per second, and ticks between echoes: each sensor gives 10 echoes per second.
inline constexpr int kControlRate = 20;
inline constexpr int kTicksPerPing = 2;
inline constexpr double kTick = 1.0 / kControlRate;  ///< [s]

/// A robot in the world with its sensors' readings. It holds all that the robot's program may see, and the
/// truth for the evaluation.
class Rig {
 public:
  /// @param start  room frame
  /// Errors: as World::create.
  static Result<Rig> create(const FieldGeometry& field, const Rover& rover, const Pose2& start,
                            double celsius, std::uint64_t seed, std::uint64_t index);

  /// Drives one tick. @return the readings of encoders and gyro
  InnerMotion step(Twist wanted);
  /// Sets the air's temperature from now on.
  void setAir(double celsius) { timer_ = EchoTimer(celsius); }
  /// Whether echoes are due after this tick; call `ping` to read them.
  bool pingDue() const { return world_.state().tick % kTicksPerPing == 0; }
  EchoTimes ping();

  /// @{ The truth, in the room frame.
  Pose2 truth() const;
  bool touchesWall() const { return !world_.contacts().empty(); }
  double seconds() const { return static_cast<double>(world_.state().tick) * kTick; }
  /// @}
  const Rover& rover() const { return rover_; }

 private:
  Rig(World world, const FieldGeometry& field, const Rover& rover, double celsius, std::uint64_t seed,
      std::uint64_t index);

  Rover rover_;
  Vec2 corner_;  ///< [m] the room's corner in the world frame
  World world_;
  SonarArray sonars_;
  WheelEncoders encoders_;
  Gyro gyro_;
  EchoTimer timer_;
};

}  // namespace fulbito::localization
