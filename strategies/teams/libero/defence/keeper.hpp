// Private header of strategies: not installed.
#pragma once

#include "strategies/teams/libero/attack/aim.hpp"
#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {

/// Where on its line the keeper should stand, y [m].
double keeperPlace(const Picture& picture, double line);
/// The same on the line on which it stands, as a point.
Vec2 keeperGoal(const Picture& picture);

/// Whether a shot is on its way that `robot`, near our goal, must save.
bool mustSave(const Picture& picture, int robot);

/// The keeper: on its line, to the crossing, and out to clear what lies near.
Twist keep(const Picture& picture, int robot);

}  // namespace fulbito::libero
