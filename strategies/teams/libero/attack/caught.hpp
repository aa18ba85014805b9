#pragma once

#include "strategies/teams/libero/attack/striker.hpp"

namespace fulbito::libero {

/// Whether a wall or a post holds a robot that wants to turn, for instance in a goal mouth. Then the robot
/// drives off for 0.15 s.
bool isCaught(const Picture& picture, const RobotState& self, StrikerMemory& memory);

/// Drives toward the field's middle. In a goal mouth the robot moves away from the post and turns out of the
/// mouth; otherwise it would come back to the same place.
Twist driveOff(const Pitch& pitch, const RobotState& self);

}  // namespace fulbito::libero
