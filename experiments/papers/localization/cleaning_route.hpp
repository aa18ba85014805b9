#pragma once

#include <vector>

#include "experiments/papers/localization/estimation/room.hpp"

namespace fulbito::localization {

/// The paper's way through a room as a chain of straight parts (Fig. 1), in the room frame.
struct CleaningRoute {
  std::vector<Vec2> points;      ///< [m] the robot turns in place at each
  std::size_t round_begins = 0;  ///< index of the point at which the way along the walls begins
  std::size_t round_ends = 0;    ///< index of the origin after that way, where the stripes begin
};

/// Straight ahead to the wall, to the corner of the origin, once round along all walls, then in stripes along
/// the longer side of the room, and back to the origin along the walls.
/// @param start    facing a wall
/// @param margin   [m] of the centre from the walls
/// @param spacing  [m] between stripes, at most
CleaningRoute cleaningRoute(const Room& room, const Pose2& start, double margin, double spacing);

/// [m] of the whole route.
double lengthOf(const CleaningRoute& route);

/// [m] of a point from the straight part between two points.
double distanceFromPart(Vec2 point, Vec2 from, Vec2 to);

}  // namespace fulbito::localization
