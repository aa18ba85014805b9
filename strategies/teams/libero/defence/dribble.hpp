#pragma once

#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// [m] offset from the ball's centre, toward the own goal's side, at which a disputed ball is met, so that it
/// slips away from the goal.
inline constexpr double kInner = 0.02;

/// Whether opponents bring the ball toward the own goal and `robot` stands in its way. In three-a-side
/// matches this is a single opponent that pushes the ball or stands ready to push it. In five-a-side matches
/// it is any opponent that pushes it.
bool canBlockDribble(const Picture& picture, const RobotState& robot);

/// Drives at such a ball, so that its pusher cannot bring it farther. If an opponent pushes it, the robot
/// aims `kInner` off its centre.
Move blockDribble(const Picture& picture, const RobotState& robot);

}  // namespace fulbito::libero
