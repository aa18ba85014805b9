#pragma once

#include <vector>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// A straight line that shows a part of a navigator's guidance.
struct GuidanceStroke {
  Vec2 from;  ///< [m]
  Vec2 to;    ///< [m]
};

/// Appends lines that show a guidance to a viewer. For a path they show all of it, within 3 mm. For a field
/// they are up to ten arrow heads, 6 cm apart, along the streamline from `position` toward `goal`. A method
/// that controls the wheels itself has none.
void addStrokes(const Guidance& guidance, Vec2 position, Vec2 goal, std::vector<GuidanceStroke>& strokes);

}  // namespace fulbito
