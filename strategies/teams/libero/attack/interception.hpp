#pragma once

#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// When and where a robot can reach the ball.
struct Interception {
  double time = 0.0;  ///< [s]
  Vec2 ball;          ///< [m] the ball's position then
};

/// The first time at which the robot can be behind the predicted ball.
Interception interception(const Picture& picture, const RobotState& robot);

}  // namespace fulbito::libero
