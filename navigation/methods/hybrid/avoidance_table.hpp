#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace fulbito {

/// Distances at which the table of P.-G. Kim et al. (2006), section IV, acts.
struct AvoidanceRanges {
  double near = 0.3;        ///< I1 [m]: up to it the robot turns away, the more the nearer the obstacle is
  double far = 0.6;         ///< I2 [m]: up to it the robot averages with the goal's direction
  bool as_printed = false;  ///< without the corrections of `avoidanceDirection`
};

/// Number of sonars in the table: 0 ... 3 look left, 4 ... 7 right.
inline constexpr std::size_t kTableSonars = 8;

/// Direction [rad, robot frame] away from the obstacle that the sonar with the least range hears; empty where
/// that is beyond `ranges.far`. By table 1, (10) and (11), with two corrections:
///  - alpha = (I1 - S)(90 deg / I1), which vanishes at S = I1; printed is I2 - S,
///  - the outermost sonars turn by 10 degrees away from their side instead of 0, since with 0 a robot that
///    slides along a wall is never corrected.
/// @param readings  [m] S of the eight sonars from left to right
/// @param goal_bearing  [rad] phi, robot frame
std::optional<double> avoidanceDirection(std::span<const double, kTableSonars> readings, double goal_bearing,
                                         const AvoidanceRanges& ranges);

}  // namespace fulbito
