#pragma once

#include <cstdint>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Quality of a robot's wheel encoders. The defaults count exactly.
struct EncoderModel {
  double counts_per_turn = 2000.0;  ///< edges per turn of a wheel
  double left_scale = 1.0;          ///< @{ counted over true travel: wheels smaller or larger than their
  double right_scale = 1.0;         ///< nominal radius, and steady slip on soft floors @}
  double slip_noise = 0.0;          ///< [m/sqrt(m)] random slip: standard deviation over one metre
};

/// What the encoders counted since they were read last.
struct EncoderCounts {
  std::int64_t left = 0;
  std::int64_t right = 0;
};

/// Encoders on the wheels of a robot of the world. They count the way of the rims, so a wheel that spins
/// counts more than the floor passes. Fractions of a count stay for the next reading.
class WheelEncoders {
 public:
  WheelEncoders(const EncoderModel& model, const RobotModel& robot, const Rng& random);

  /// Counts of one tick of `dt` [s] that brought the robot from `before` to `after`.
  EncoderCounts read(const RobotState& before, const RobotState& after, double dt);
  /// [m] nominal way of a rim per count
  double metresPerCount() const { return metres_per_count_; }

 private:
  std::int64_t count(double travel, double scale, double& rest);

  EncoderModel model_;
  double radius_;            // [m]
  double half_track_;        // [m]
  double metres_per_count_;  // [m]
  double left_rest_ = 0.0;   // [m] counted later
  double right_rest_ = 0.0;  // [m]
  Rng random_;
};

}  // namespace fulbito
