#pragma once

#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// The first time at which the robot can be behind the predicted ball.
Interception interception(const Picture& picture, const RobotState& robot);

}  // namespace fulbito::libero
