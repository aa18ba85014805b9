#pragma once

#include <cstdint>
#include <span>

#include "engine/core/vec2.hpp"

namespace fulbito {

/// A place on a polyline.
struct PathPlace {
  std::size_t segment = 0;  ///< between points `segment` and `segment + 1`
  double fraction = 0.0;    ///< 0 ... 1 of that segment
};

/// Keeps the place of a robot on a path from tick to tick, so that a path that crosses or nears itself is not
/// short-cut and the search costs a few segments a tick.
class PathTracker {
 public:
  void reset() { known_ = false; }
  /// Nearest place on `path` to `p`; a new `revision` searches the whole path, otherwise a window ahead of
  /// the last place.
  PathPlace locate(std::span<const Vec2> path, std::uint64_t revision, Vec2 p);

 private:
  bool known_ = false;
  std::uint64_t revision_ = 0;
  PathPlace place_;
};

/// The point at `place`.
Vec2 pointAt(std::span<const Vec2> path, PathPlace place);
/// The place `length` [m] further along; the last point when the path ends before.
PathPlace advance(std::span<const Vec2> path, PathPlace place, double length);

}  // namespace fulbito
