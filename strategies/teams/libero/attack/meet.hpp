// Private header of strategies: not installed.
#pragma once

#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// How far off its middle [m], on our goal's side, a disputed ball is met, so that it slips away from the
/// goal.
inline constexpr double kInner = 0.02;

/// Whether an opponent pushes the ball toward our goal; its velocity is below -0.3 m/s along x then.
bool carried(const Picture& picture);

/// Whether opponents bring the ball toward our goal and `robot` stands in its way. Three a side that is one
/// opponent, which pushes the ball or stands ready to; five a side whoever pushes it.
bool canMeetBrought(const Picture& picture, const RobotState& robot);

/// Drives at such a ball, whose pusher can then bring it no farther. A pushed one is met `kInner` off
/// its middle.
Twist meetBrought(const Picture& picture, const RobotState& robot);

}  // namespace fulbito::libero
