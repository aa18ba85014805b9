#pragma once

#include <span>

#include "fulbito/models.hpp"

namespace fulbito {

/// Limits under which a path is timed.
struct SpeedLimits {
  double max_speed = 1.0;     ///< [m/s] of a wheel's rim
  double acceleration = 5.0;  ///< [m/s^2] of a wheel's rim
  double lateral = 6.0;       ///< [m/s^2] across the wheels
  double axle_track = 0.075;  ///< [m]
  double start_speed = 0.0;   ///< [m/s] at the first point
  double end_speed = 1e9;     ///< [m/s] allowed at the last point
};

/// The limits of `robot`. The shares (0 ... 1] of its wheel acceleration and lateral grip leave a reserve.
SpeedLimits speedLimits(const RobotModel& robot, double acceleration_share, double lateral_share);

/// Curvature [1/m] at each point of a polyline, from the circle through the point and the points two before
/// and two after it. The vertices of a coarse polyline do not disturb this circle. Next to the ends it uses
/// the direct neighbours; at the ends it is 0.
/// @param curvature  same size as `path`
void pathCurvature(std::span<const Vec2> path, std::span<double> curvature);

/// Fastest speeds along a path of given curvature under the limits: pointwise caps, then a forward and a
/// backward pass (the wheels' rim acceleration in a bend of radius R is (1 + b/2R) times the robot's).
/// @param speeds  same size as `path`; every entry is at least 1 cm/s, except where end_speed is lower
/// @return travel time [s]
double timePath(std::span<const Vec2> path, std::span<const double> curvature, const SpeedLimits& limits,
                std::span<double> speeds);

}  // namespace fulbito
