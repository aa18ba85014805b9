#pragma once

#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// The place [m] of a robot without the ball: between ball and own goal in defence, at the rebound in attack,
/// never near the striker's ball or in an area. `rank` counts the robots without the ball from 0.
Vec2 supportPlace(const Picture& picture, int robot, int rank);

/// The place [m] of a robot while only the keeper may play the ball: beside the area and ready for balls that
/// come out. It is out of the way of opponents that run at the ball and would push the robot into the area.
Vec2 waitingPlace(const Picture& picture, int rank);

/// Drives to `place` round mates and opponents.
Twist supportTo(const Picture& picture, int robot, Vec2 place);

}  // namespace fulbito::libero
