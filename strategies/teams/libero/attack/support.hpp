#pragma once

#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Where a robot without the ball should be: between ball and own goal when we defend, at the rebound when we
/// attack, never at the striker's ball nor in an area. `rank` counts the robots without the ball, 0 first.
Vec2 supportPlace(const Picture& picture, int robot, int rank);

/// Where they wait while the ball is the keeper's alone: beside the area, off the way of robots that run at
/// it, which would push them in, and ready for what comes out.
Vec2 waitingPlace(const Picture& picture, int rank);

/// Drives there, round mates and opponents.
Twist supportTo(const Picture& picture, int robot, Vec2 place);

}  // namespace fulbito::libero
