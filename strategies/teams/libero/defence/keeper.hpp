#pragma once

#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Whether the ball rolls into the own goal and `robot`, which is near the goal, must save it.
bool mustSave(const Picture& picture, int robot);

/// The keeper's move: along its line to the crossing, or off the line to clear a near ball.
Move keep(const Picture& picture, int robot);

}  // namespace fulbito::libero
