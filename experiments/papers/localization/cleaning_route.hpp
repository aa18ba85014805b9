#pragma once

#include <vector>

#include "experiments/papers/localization/estimation/room.hpp"

namespace fulbito::localization {

/// The paper's route through a room as a chain of straight parts (Fig. 1), in the room frame.
struct CleaningRoute {
  std::vector<Vec2> points;      ///< [m] the robot turns in place at each
  std::size_t round_begins = 0;  ///< index of the point at which the round along the walls begins
  std::size_t round_ends = 0;    ///< index of the origin after the round, where the stripes begin
};

/// The route leads straight ahead to the wall, to the corner of the origin and once round along all walls.
/// Then it covers the room in stripes along its longer side and returns to the origin along the walls.
/// @param start    facing a wall
/// @param margin   [m] from the robot's centre to the walls
/// @param spacing  [m] greatest distance between stripes
CleaningRoute cleaningRoute(const Room& room, const Pose2& start, double margin, double spacing);

/// Length [m] of the whole route.
double lengthOf(const CleaningRoute& route);

/// Distance [m] from a point to the straight part between two points.
double distanceFromPart(Vec2 point, Vec2 from, Vec2 to);

}  // namespace fulbito::localization
