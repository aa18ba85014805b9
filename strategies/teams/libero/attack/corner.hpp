#pragma once

#include "strategies/teams/libero/attack/aim.hpp"

namespace fulbito::libero {

/// Whether the ball lies at a wall of the own half, the robot is close behind it, and an opponent is near.
/// Then a robot whose face leans into the wall squeezes the ball along it. A robot that drives round the ball
/// would only hold it there. `rel` [m] is the ball seen from the robot.
bool squeezes(const Picture& picture, Vec2 rel, const Aim& aim);

/// Pushes that ball along the wall.
Twist squeeze(const Picture& picture, const RobotState& self, Vec2 rel, const Aim& aim);

/// Whether a robot is on its way to such a ball. The robot that arrives first gets the ball.
bool racesAlongWall(const Picture& picture, Vec2 rel, const Aim& aim);

/// Drives straight to that ball, at a point slightly behind it along the wall. Turning parallel to the wall
/// first would cost 0.1 s.
Twist raceAlongWall(const Picture& picture, const RobotState& self, const Aim& aim);

}  // namespace fulbito::libero
