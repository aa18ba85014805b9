#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/situation/pitch.hpp"

namespace fulbito::libero {

/// Where the team stands at a restart (docs/libero.md, Restarts). Robot 0 keeps goal, robot 1 takes
/// it. `hand`, +1 or -1, tells to which side kick-offs are played that are alike on both; at the others it
/// follows from where the ball lies or the rules place robots, whose tables are mirrored, not turned, between
/// the sides.
TeamPlacement placementAt(const Pitch& pitch, const PlacementRequest& request, double hand);

}  // namespace fulbito::libero
