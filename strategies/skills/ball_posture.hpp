#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/prediction/time_to_reach.hpp"

/// Posture at the ball: being behind it with the heading in which it shall go (docs/skills.md, Strike). The
/// ways there are the navigators' business; these skills say where to and when to strike.
namespace fulbito {

/// How a robot stands to a ball that shall go along a direction.
struct BallSide {
  double behind = 0.0;        ///< [m] of the robot's centre behind the ball's, along the direction
  double aside = 0.0;         ///< [m] to the left of the line through the ball
  double misalignment = 0.0;  ///< [rad] of the end that leads from the direction, in [-pi/2, pi/2]
  bool backward = false;      ///< its back leads
};

/// `direction`: unit, in which the ball shall go.
BallSide sideOfBall(const RobotState& robot, Vec2 ball, Vec2 direction);

struct PostureSettings {
  double standoff =
      0.03;  ///< [m] of the place to drive to behind the ball, once the robot is on the right side
  double detour = 0.11;        ///< [m] of the place to drive to behind the ball while it is on the wrong side
  double line_aside = 0.02;    ///< [m] farther off the line a robot is not lined up
  double line_heading = 0.20;  ///< [rad] the same for its heading
  double line_behind = 0.15;   ///< [m] farther from the ball it is not lined up
  double release_aside = 0.035;  ///< [m] a strike goes on up to here
};

/// Where a robot drives to get behind the ball: to the ball itself with the wanted heading when it is on the
/// right side, round it with the ball as an obstacle when it is not. `was_round` is the answer before: the
/// side is kept until the robot is clearly past.
struct BallApproach {
  GoTo go_to;
  bool round = false;  ///< it goes round the ball
};
BallApproach approachBall(const RobotState& robot, Vec2 ball, Vec2 direction, bool was_round,
                          const PostureSettings& settings = {});

/// Whether a robot may drive straight through the ball. `was_lined_up` is the answer before (hysteresis).
bool isLinedUp(const BallSide& side, bool was_lined_up, const PostureSettings& settings = {});

/// Drives along `direction` at `speed` [m/s] with the end that leads, through a ball that lies ahead.
Twist strike(const RobotState& robot, Vec2 ball, Vec2 direction, double speed);

}  // namespace fulbito
