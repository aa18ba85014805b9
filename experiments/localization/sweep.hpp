#pragma once

#include <optional>
#include <span>

namespace fulbito::localization {

/// One echo of the front sensor during a sweep.
struct SweepEcho {
  double heading = 0.0;        ///< [rad] of the robot by its gyro, not wrapped
  std::optional<double> time;  ///< [s]
};

/// The direction of a wall in a sweep.
struct WallDirection {
  double heading = 0.0;    ///< [rad] perpendicular to it
  bool at_edge = false;    ///< the wall goes on beyond the sweep: sweep again around `heading`
};

/// The heading in the middle of all near-shortest echoes. A sensor with a wide cone hears a wall's
/// perpendicular over the whole width of the cone, so the shortest echo alone is a draw among many.
/// @param noise  [s] standard deviation of an echo time
/// @return empty without echoes
std::optional<WallDirection> wallDirection(std::span<const SweepEcho> sweep, double noise);

}  // namespace fulbito::localization
