// Private header of strategies: not installed.
#pragma once

#include "strategies/libero_motion.hpp"
#include "strategies/libero_picture.hpp"

namespace fulbito::libero {

/// Where a robot without the ball should be: between ball and own goal when it defends, at the rebound when
/// we attack. `rank` counts the robots without the ball, 0 first.
Vec2 supportPlace(const Picture& picture, Vec2 striker, int rank);

/// Drives there, round mates and opponents.
Twist supportTo(const Picture& picture, int robot, Vec2 place);

}  // namespace fulbito::libero
