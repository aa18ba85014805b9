// Private header of strategies: not installed.
#pragma once

#include "strategies/libero_aim.hpp"
#include "strategies/libero_motion.hpp"

namespace fulbito::libero {

struct KeeperMemory {
  double spin_left = 0.0;
  double spin_sense = 1.0;
  double locked = 0.0;
  double pressed = 0.0;  ///< [s]
};

/// Where on its line the keeper should stand, y [m].
double keeperPlace(const Picture& picture, double line);

/// Whether a shot is on its way that `robot`, near our goal, must save.
bool mustSave(const Picture& picture, int robot);

/// The keeper: on its line, to the crossing, and out to clear what lies near.
Twist keep(const Picture& picture, int robot, KeeperMemory& memory);

}  // namespace fulbito::libero
