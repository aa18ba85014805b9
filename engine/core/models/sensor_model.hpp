#pragma once

#include "engine/core/base/result.hpp"

namespace fulbito {

/// How well robots and ball are seen: late, with noise, with gaps. The defaults are the truth.
struct SensorModel {
  int latency_ticks = 0;        ///< age of every picture, 0 ... 60
  double position_noise = 0.0;  ///< [m] standard deviation of each coordinate, 0 ... 0.1
  double heading_noise = 0.0;   ///< [rad] standard deviation of headings, 0 ... 2 pi
  double dropout = 0.0;  ///< chance that a body is not seen in a tick, 0 ... 0.99: its last sight stays

  /// Whether the truth of this tick is seen.
  bool perfect() const { return *this == SensorModel{}; }
  friend bool operator==(const SensorModel&, const SensorModel&) = default;
};

/// @{ Ends of the ranges of a sensor model.
inline constexpr int kMaxLatencyTicks = 60;
inline constexpr double kMaxPositionNoise = 0.1;         // [m]
inline constexpr double kMaxHeadingNoise = 6.283185307;  // [rad] beyond it a heading says nothing
inline constexpr double kMaxDropout = 0.99;
/// @}

/// The heading noise [rad] of a camera that sees positions with `position_noise` [m]: the heading comes from
/// a mark half a body [m] before the centre, which is off to the side by that much.
double headingNoise(double position_noise, double body_length);

/// Errors: kUsage naming what is out of its range.
Result<void> validate(const SensorModel& sensors);

}  // namespace fulbito
