#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/prediction/time_to_reach.hpp"

/// Skills that place a robot behind the ball with the heading of the wanted strike (docs/skills.md, Strike).
/// They give the place and the moment of the strike; navigators plan the path.
namespace fulbito {

/// The pose of a robot relative to a ball and the wanted direction of a strike.
struct BallSide {
  double behind = 0.0;        ///< [m] distance of the robot's centre behind the ball's, along the direction
  double aside = 0.0;         ///< [m] distance of the robot's centre to the left of the line through the ball
  double misalignment = 0.0;  ///< [rad] angle from the direction to the leading end, in [-pi/2, pi/2]
  bool backward = false;      ///< the robot's back leads
};

/// The robot's pose relative to the ball; `direction` is the unit vector of the wanted strike.
BallSide sideOfBall(const RobotState& robot, Vec2 ball, Vec2 direction);

/// Distances and angles of the approach to the ball.
struct PostureSettings {
  double standoff = 0.03;        ///< [m] of the target behind the ball, from the right side
  double detour = 0.11;          ///< [m] of the target behind the ball, from the wrong side
  double line_aside = 0.02;      ///< [m] largest distance from the line of a robot that is lined up
  double line_heading = 0.20;    ///< [rad] largest misalignment of a robot that is lined up
  double line_behind = 0.15;     ///< [m] largest distance from the ball of a robot that is lined up
  double release_aside = 0.035;  ///< [m] a strike continues up to this distance from the line
};

/// The approach to the place behind the ball.
struct BallApproach {
  GoTo go_to;          ///< the place to drive to
  bool round = false;  ///< the robot drives round the ball
};
/// The approach to the ball. From the right side, the robot drives to the ball with the wanted heading. From
/// the wrong side, it drives round the ball as an obstacle. `was_round` is the previous `round`, for
/// hysteresis.
BallApproach approachBall(const RobotState& robot, Vec2 ball, Vec2 direction, bool was_round,
                          const PostureSettings& settings = {});

/// Whether a robot may drive straight through the ball. `was_lined_up` is the previous result (hysteresis).
bool isLinedUp(const BallSide& side, bool was_lined_up, const PostureSettings& settings = {});

/// Drives along `direction` at `speed` [m/s] with the leading end, through the ball ahead.
Twist strike(const RobotState& robot, Vec2 ball, Vec2 direction, double speed);

}  // namespace fulbito
