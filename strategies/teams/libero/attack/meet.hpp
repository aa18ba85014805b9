#pragma once

#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// How far off its middle [m], on our goal's side, a disputed ball is met, so that it slips away from the
/// goal.
inline constexpr double kInner = 0.02;

/// Whether an opponent pushes the ball toward our goal; its velocity is below -0.3 m/s along x then.
bool opponentDribblesAtGoal(const Picture& picture);

/// Whether opponents bring the ball toward our goal and `robot` stands in its way. Three a side that is a
/// single opponent, which pushes the ball or stands ready to; five a side any that pushes it.
bool canBlockDribble(const Picture& picture, const RobotState& robot);

/// Drives at such a ball, so that its pusher brings it no farther. A pushed one is met `kInner` off its
/// middle.
Move blockDribble(const Picture& picture, const RobotState& robot);

}  // namespace fulbito::libero
