// Private header of strategies: not installed.
#pragma once

#include "strategies/libero_picture.hpp"

namespace fulbito::libero {

/// Whether an opponent pushes the ball toward our goal; its velocity is below -0.3 m/s along x then.
bool carried(const Picture& picture);

/// Whether opponents bring the ball toward our goal and `robot` stands in its way. Three a side that is one
/// opponent, which pushes the ball or stands ready to; five a side whoever pushes it.
bool canMeetBrought(const Picture& picture, const RobotState& robot);

/// Drives at such a ball, whose pusher can then bring it no farther. A pushed one is met off its middle, on
/// our goal's side: it slips from those who push it, away from the goal.
Twist meetBrought(const Picture& picture, const RobotState& robot);

}  // namespace fulbito::libero
