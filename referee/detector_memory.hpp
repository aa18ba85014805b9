#pragma once

#include <array>

#include "engine/core/vec2.hpp"
#include "referee/areas.hpp"

namespace fulbito {

/// A tick so long ago that nothing recent is meant.
inline constexpr Tick kLongAgo = -1000000000;

/// Who touched what when, by a robot's place in the view.
struct TouchMemory {
  std::array<Tick, kMostRobots> ball = [] {
    std::array<Tick, kMostRobots> all{};
    all.fill(kLongAgo);
    return all;
  }();
};

/// Of the stuck ball.
struct StuckMemory {
  bool counting = false;
  Tick since = 0;        ///< the count began
  Vec2 anchor;           ///< [m] where the ball was then
  Tick fast_since = -1;  ///< the ball has been too fast since; -1: it is not
};

/// What the detectors know between ticks: a plain value, empty at every restart.
struct DetectorMemory {
  AreaReport areas{};  ///< of the tick before
  TouchMemory touches;
  StuckMemory stuck;
};

}  // namespace fulbito
