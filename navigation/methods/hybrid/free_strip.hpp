#pragma once

#include <optional>
#include <vector>

#include "navigation/obstacles/proven_map.hpp"

namespace fulbito {

/// A straight way through between what stands on its left and on its right, world frame.
struct FreeStrip {
  Vec2 middle;         ///< [m] a point in its middle
  Vec2 axis;           ///< unit, along it
  double width = 0.0;  ///< [m]
  double entry = 0.0;  ///< [m] along it from `middle`: where the first thing beside it begins
  double exit = 0.0;   ///< [m] where the last ends

  double along(Vec2 place) const { return dot(place - middle, axis); }
  double aside(Vec2 place) const { return cross(axis, place - middle); }  ///< [m] to the left of the axis
};

/// Finds the widest strip between two bodies of any shape. Convex bodies are farthest apart across the strip
/// that touches both: all directions within 0.6 rad of the way are tried.
class StripFinder {
 public:
  /// The strip between the occupied cells about `middle`, left and right of the direction `way` (unit). Empty
  /// where one side has none.
  /// @param size  see `bodySize`
  std::optional<FreeStrip> find(const ProvenMap& map, Vec2 middle, Vec2 way, double size);
  /// Moves the exit of `strip` on where something stands beside it within `reach` [m] of `place`.
  static void prolong(const ProvenMap& map, Vec2 place, double reach, double size, FreeStrip& strip);

 private:
  std::vector<Vec2> left_, right_;
};

}  // namespace fulbito
