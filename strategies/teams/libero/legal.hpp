#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/playbook/memory.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// The last step of a decision: `wanted`, changed as far as it would be a foul. Only the keeper may enter the
/// own area. In three-a-side matches only the striker may enter the opponents' area. No robot may press on
/// their keeper without the ball. Mates yield to each other.
RobotCommand legal(const Picture& picture, int robot, Twist wanted, Memory& memory);

}  // namespace fulbito::libero
