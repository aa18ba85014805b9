#pragma once

#include "strategies/teams/libero/attack/aim.hpp"

namespace fulbito::libero {

/// Whether the ball is slower than `speed` [m/s] at a wall, the robot is behind it, and an
/// opponent is within `rival` [m] of it. `rel` [m] is the ball seen from the robot.
bool isFoughtFor(const Picture& picture, Vec2 rel, const Aim& aim, double speed, double rival);

/// Whether a robot is next to a ball that can be pushed, and that an opponent fights for at a wall.
bool isPressed(const Picture& picture, int robot, const Aim& aim);

}  // namespace fulbito::libero
