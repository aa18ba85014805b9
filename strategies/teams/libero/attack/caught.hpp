#pragma once

#include "strategies/teams/libero/attack/striker.hpp"

namespace fulbito::libero {

/// Whether a robot that wants to turn is held by a wall or a post, as in a goal's mouth; then it drives off,
/// as it stands, for a moment.
bool isCaught(const Picture& picture, const RobotState& self, StrikerMemory& memory);

/// Toward the field's middle; in a goal's mouth away from the post, and turning out of it, or it comes
/// straight back to the same place.
Twist driveOff(const Pitch& pitch, const RobotState& self);

}  // namespace fulbito::libero
