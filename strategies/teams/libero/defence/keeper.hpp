#pragma once

#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Whether a shot is on its way that `robot`, near our goal, must save.
bool mustSave(const Picture& picture, int robot);

/// The keeper: on its line, to the crossing, and out to clear what lies near.
Move keep(const Picture& picture, int robot);

}  // namespace fulbito::libero
