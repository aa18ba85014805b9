#pragma once

#include "strategies/teams/libero/attack/aim.hpp"

namespace fulbito::libero {

/// Whether the ball lies at a wall of our half with us behind it and an opponent about it, and we are at it.
/// Then a face that leans into the wall squeezes it along; a robot that comes round it only holds it
/// there. `rel` [m] is the ball seen from the robot.
bool squeezes(const Picture& picture, Vec2 rel, const Aim& aim);

/// Pushes that ball along its wall.
Twist squeeze(const Picture& picture, const RobotState& self, Vec2 rel, const Aim& aim);

/// The same of a robot on its way to such a ball: the first at it has it.
bool racesAlongWall(const Picture& picture, Vec2 rel, const Aim& aim);

/// Straight at that ball, a little behind it as seen along the wall: turning in along the wall first costs a
/// tenth of a second.
Twist raceAlongWall(const Picture& picture, const RobotState& self, const Aim& aim);

}  // namespace fulbito::libero
