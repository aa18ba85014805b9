#pragma once

#include <vector>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// A straight line that shows a part of what a navigator wants.
struct GuidanceStroke {
  Vec2 from;  ///< [m]
  Vec2 to;    ///< [m]
};

/// Appends lines that show a guidance to a viewer: of a path all of it, within 3 mm; of a field arrow heads
/// along the way on which it leads a point from `position` toward `goal`, 6 cm apart, ten at most. Nothing of
/// a method that controls the wheels itself.
void addStrokes(const Guidance& guidance, Vec2 position, Vec2 goal, std::vector<GuidanceStroke>& strokes);

}  // namespace fulbito
