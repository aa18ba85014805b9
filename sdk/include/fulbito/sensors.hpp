// Sensors on robots of a world, each with errors of its own: sonars, wheel encoders, gyros. And what rays and
// cones meet in a world: walls and bodies. Component `world`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "fulbito/detail/echo_scene.hpp"
#include "fulbito/detail/random.hpp"
#include "fulbito/detail/sonar_model.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// Stands for "no robot of the world".
inline constexpr std::size_t kNoRobot = std::numeric_limits<std::size_t>::max();

/// Outlines of all walls and bodies of a world, for rays and cones.
class WorldOutlines {
 public:
  /// @param field  the field of all worlds to trace
  explicit WorldOutlines(const FieldGeometry& field);
  /// The world's outlines as its bodies stand now; valid until the next call.
  /// @param without  index of a robot that is left out, e.g. the one that looks
  const EchoScene& trace(const World& world, std::size_t without = kNoRobot);

 private:
  std::vector<Vec2> contour_;  // outline of the field
  EchoScene scene_;            // outlines of the last trace
};

/// The first surface in the world along the unit vector `direction` from `from`, within `range` [m]. For many
/// rays at one tick, use `WorldOutlines::trace` and `EchoScene::castRay`.
/// @param without  index of a robot that is left out
RayHit castRay(const World& world, Vec2 from, Vec2 direction, double range, std::size_t without = kNoRobot);

/// The ultrasonic sensors of one robot. Each listens in its cone for the nearest surface that reflects its
/// call (see EchoScene::castCone). The robot's own body is no obstacle to them. Deterministic: the same world
/// and stream give the same readings. Allocates nothing once warm.
class SonarArray {
 public:
  /// @param field  the field of all worlds to measure in
  /// @param model  valid, see `validate`
  /// @param random  a stream of its own, e.g. Rng(seed, Stream::kSonar, trial)
  SonarArray(const FieldGeometry& field, SonarModel model, const Rng& random);

  /// Fires all sonars of the world's robot `robot` once. The readings stay valid until the next call.
  std::span<const SonarReading> measure(const World& world, std::size_t robot);
  /// The echoes of the last measurement without errors, in the world's frame.
  std::span<const Echo> echoes() const { return echoes_; }
  const SonarModel& model() const { return model_; }  ///< places and errors of the sonars

 private:
  double heardRange(std::size_t sonar);                               // [m] with errors
  double strayRange(std::size_t sonar, std::size_t neighbour) const;  // [m] for a neighbour's call

  SonarModel model_;
  Rng random_;
  WorldOutlines outlines_;
  std::vector<Cone> cones_;             // cones in the world's frame
  std::vector<Echo> echoes_;            // echoes without errors
  std::vector<SonarReading> readings_;  // readings of the last measurement
};

/// Speed of sound [m/s] in dry air of `celsius` [degrees], at least -273.15: 331.3 m/s times the root of the
/// absolute temperature over that of melting ice.
double speedOfSound(double celsius);

/// Times echoes like the counter of an ultrasonic sensor: in whole microseconds from the pulse to its echo.
/// To get a distance from the count, the reader must assume a temperature.
class EchoTimer {
 public:
  /// @param celsius  temperature of the air; it must have a speed of sound above 0
  explicit EchoTimer(double celsius) : per_metre_(2e6 / speedOfSound(celsius)) {}

  /// The count [us] for a wall `range` [m] away, which is finite; 0 for a negative range.
  std::int64_t microseconds(double range) const;

 private:
  double per_metre_;  // [us/m] there and back
};

/// Quality of a robot's wheel encoders. The defaults count exactly.
struct EncoderModel {
  double counts_per_turn = 2000.0;  ///< edges per turn of a wheel
  double left_scale = 1.0;          ///< @{ counted over true travel: wheels smaller or larger than their
  double right_scale = 1.0;         ///< nominal radius, and steady slip on soft floors @}
  double slip_noise = 0.0;          ///< [m/sqrt(m)] random slip: standard deviation over one metre
};

/// Counts of the encoders since the last reading.
struct EncoderCounts {
  std::int64_t left = 0;   ///< of the left wheel
  std::int64_t right = 0;  ///< of the right wheel
};

/// Encoders on the wheels of a robot of the world. They count the travel of the rims, so a spinning wheel
/// counts more than it moves over the floor. Fractions of a count stay for the next reading.
class WheelEncoders {
 public:
  /// @param random  a stream of its own for the slip
  WheelEncoders(const EncoderModel& model, const RobotModel& robot, const Rng& random);

  /// Counts of one tick of `dt` [s] that brought the robot from `before` to `after`.
  EncoderCounts read(const RobotState& before, const RobotState& after, double dt);
  /// Nominal travel [m] of a rim per count.
  double metresPerCount() const { return metres_per_count_; }

 private:
  // Counts for the travel [m] of one rim; `rest` is the travel that is not counted yet.
  std::int64_t count(double travel, double scale, double& rest);

  EncoderModel model_;
  double radius_;            // [m]
  double half_track_;        // [m]
  double metres_per_count_;  // [m]
  double left_rest_ = 0.0;   // [m] travel that is not counted yet
  double right_rest_ = 0.0;  // [m]
  Rng random_;
};

/// Quality of a yaw-rate gyro. The defaults give the true rate.
struct GyroModel {
  double bias = 0.0;   ///< [rad/s] bias at the start
  double drift = 0.0;  ///< [rad/s/sqrt(s)] random walk of the bias: its standard deviation after one second
  double noise = 0.0;  ///< [rad/s] standard deviation of each reading
  double scale = 1.0;  ///< measured over true rate
};

/// A gyro on a robot of the world. Its bias is a random walk.
class Gyro {
 public:
  /// @param random  a stream of its own for noise and drift
  Gyro(const GyroModel& model, const Rng& random) : model_(model), bias_(model.bias), random_(random) {}

  /// Mean yaw rate [rad/s] over a tick of `dt` [s] in which the robot turned by `turned` [rad].
  double read(double turned, double dt);
  /// The present bias [rad/s].
  double bias() const { return bias_; }

 private:
  GyroModel model_;
  double bias_;  // [rad/s] present bias
  Rng random_;
};

}  // namespace fulbito
