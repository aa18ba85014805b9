#pragma once

#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Whether opponents bring the ball toward the own goal and `robot` stands in its way. In three-a-side
/// matches this is a single opponent that pushes the ball or stands ready to push it. In five-a-side matches
/// it is any opponent that pushes it.
bool canBlockDribble(const Picture& picture, const RobotState& robot);

/// Drives at such a ball, so that its pusher cannot bring it farther. If an opponent pushes it, the robot
/// aims at its edge on the side of the goal, so that it slips away from the goal.
Move blockDribble(const Picture& picture, const RobotState& robot);

}  // namespace fulbito::libero
