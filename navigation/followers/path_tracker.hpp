#pragma once

#include <cstdint>

#include "navigation/geometry/polyline.hpp"

namespace fulbito {

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

}  // namespace fulbito
