#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/situation/pitch.hpp"

namespace fulbito::libero {

/// Where the team stands at a restart (docs/libero.md, Restarts). Robot 0 keeps goal, and robot 1 takes the
/// restart. `hand`, +1 or -1, is the side of a kick-off that is alike on both sides. At other restarts the
/// ball's place or the default places of the rules, which are mirrored between the sides, decide the side.
TeamPlacement placementAt(const Pitch& pitch, const PlacementRequest& request, double hand);

}  // namespace fulbito::libero
