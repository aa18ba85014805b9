#pragma once

#include <cstdint>

#include "navigation/geometry/polyline.hpp"

namespace fulbito {

/// Tracks the place of a robot on a path from tick to tick. So it does not jump to another part of a path
/// that crosses itself, and each tick searches only a few segments.
class PathTracker {
 public:
  void reset() { known_ = false; }
  /// Nearest place on `path` to `p`. A new `revision` searches the whole path; otherwise only a window ahead
  /// of the last place is searched.
  PathPlace locate(std::span<const Vec2> path, std::uint64_t revision, Vec2 p);

 private:
  bool known_ = false;
  std::uint64_t revision_ = 0;
  PathPlace place_;
};

}  // namespace fulbito
