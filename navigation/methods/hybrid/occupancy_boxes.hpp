#pragma once

#include <optional>
#include <span>

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// The boxes in front of the robot of P.-G. Kim et al. (2006), section III: side by side, on both sides of
/// the robot's x axis.
struct OccupancyBoxes {
  double width = 0.05;  ///< [m] of one box, across
  double length = 1.5;  ///< [m] of one box, ahead
  int per_side = 6;     ///< boxes left and right, at most kMostBoxes
};

inline constexpr int kMostBoxes = 16;

/// What the boxes say about the obstacle ahead, robot frame.
struct FrontSection {
  Vec2 first, second;  ///< P1 and P2: the echoes between which the section runs

  /// (7) to (9): the midpoint of the two.
  Vec2 centre() const { return (first + second) / 2; }
  /// Their distance [m]: 0 where only one box is occupied.
  double width() const { return distance(first, second); }
};

/// The section of the obstacle ahead. Each box keeps its echo with the smallest x. With echoes on one side,
/// the section runs from the occupied box nearest the x axis to the farthest; with echoes on both, from the
/// farthest on the left to the farthest on the right. Empty: no box is occupied.
/// @param echoes  [m] robot frame
std::optional<FrontSection> frontSection(std::span<const Vec2> echoes, const OccupancyBoxes& boxes);

}  // namespace fulbito
