#pragma once

#include <optional>

#include "fulbito/strategy.hpp"
#include "strategies/prediction/ball_prediction.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito {

/// A meeting of robot and ball.
struct Interception {
  double time = 0.0;  ///< [s] from now
  Vec2 ball;          ///< [m] where the ball is then
  Vec2 robot;         ///< [m] where the robot is then
};

/// What the robot shall do at the ball.
struct InterceptionRequest {
  std::optional<Vec2> aim;  ///< strike toward this: the robot comes to the ball's far side of it
  double standoff = 0.06;   ///< [m] robot centre to ball centre at the meeting
  double horizon = 4.0;     ///< [s]
};

/// The earliest time at which the robot can be at the ball's predicted place, or (with `aim`) behind it
/// (docs/skills.md, Interception). It marches forward by the time that is still missing, which cannot
/// overshoot the first meeting as long as the robot is the faster, and closes in by a secant. Empty when
/// there is none within the horizon.
std::optional<Interception> intercept(const BallPrediction& ball, const RobotPace& pace,
                                      const RobotState& robot, const InterceptionRequest& request = {});

}  // namespace fulbito
