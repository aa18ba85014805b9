#pragma once

#include <optional>

#include "fulbito/strategy.hpp"
#include "strategies/prediction/ball_prediction.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito {

/// A meeting of robot and ball.
struct Interception {
  double time = 0.0;  ///< [s] from now
  Vec2 ball;          ///< [m] the ball's position then
  Vec2 robot;         ///< [m] the robot's position then
};

/// The wanted kind of interception.
struct InterceptionRequest {
  std::optional<Vec2> aim;  ///< [m] target of a strike: the robot comes to the opposite side of the ball
  double standoff = 0.06;   ///< [m] robot centre to ball centre at the meeting
  double horizon = 4.0;     ///< [s] latest meeting
};

/// The earliest meeting of the robot with the predicted ball or, with `aim`, with the place behind the ball
/// (docs/skills.md, Interception). The search steps forward by the missing time, then refines by secants. It
/// cannot skip the first meeting if the robot is faster than the ball. Empty if there is no meeting within
/// the horizon.
std::optional<Interception> intercept(const BallPrediction& ball, const RobotPace& pace,
                                      const RobotState& robot, const InterceptionRequest& request = {});

}  // namespace fulbito
