#pragma once

#include <array>
#include <span>

#include "fulbito/detail/layout.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// A rectangle in the plane.
struct Rectangle {
  Pose2 pose;
  double length = 0.0;  ///< [m] along its x
  double width = 0.0;   ///< [m] along its y
};

/// The robot's body at `pose`.
Rectangle bodyOf(const RobotModel& robot, const Pose2& pose);

/// Its corners, counter-clockwise.
std::array<Vec2, 4> cornersOf(const Rectangle& rectangle);

/// @{ Distance [m] between two shapes; minus the penetration depth if they overlap.
double clearance(const Rectangle& body, Vec2 centre, double radius);
double clearance(const Rectangle& a, const Rectangle& b);
/// @}

/// Distance [m] from the body to an obstacle at `pose`.
double clearance(const Rectangle& body, const ObstacleSpec& obstacle, const Pose2& pose);

/// Distance [m] from the body to the walls along `contour` (see innerContour), goals included; negative if a
/// corner is behind a wall.
double clearance(const Rectangle& body, std::span<const Vec2> contour);

}  // namespace fulbito
