// Private header of strategies: not installed.
#pragma once

#include "strategies/libero_pitch.hpp"
#include "strategies/strategy.hpp"

namespace fulbito::libero {

/// Where the team stands at a restart (set plays of the reference page, 3). Robot 0 keeps goal, robot 1 takes
/// it.
TeamPlacement placementAt(const Pitch& pitch, const PlacementRequest& request);

}  // namespace fulbito::libero
