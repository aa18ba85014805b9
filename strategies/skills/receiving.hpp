#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito {

/// Receiving a rolling ball: the robot drives behind the ball on the same line at the same speed, so that the
/// first touch does not push the ball away. The idea is the last part of a capture by Choi & Lee (2005): same
/// line, same heading, same speed (docs/skills.md, Receiving).
struct ReceivingSettings {
  double standoff = 0.055;    ///< [m] from the ball's centre to the robot's centre behind it
  double detour = 0.10;       ///< [m] from the ball's line while the robot is in front of the ball
  double gain = 3.0;          ///< [1/s] added speed per distance to the place
  double yaw_gain = 10.0;     ///< [1/s] yaw rate per heading error
  double least_speed = 0.05;  ///< [m/s] for a slower ball the direction is from the robot to the ball
};

/// The place [m] that the robot aims at now: behind the ball, or beside its way while the robot is in front.
Vec2 receivingPlace(const RobotState& robot, const BallState& ball, const ReceivingSettings& settings = {});

/// Drives the robot to that place. The ball's velocity is added, so that the robot has it at the place. The
/// nearer end leads.
Twist receive(const RobotState& robot, const BallState& ball, const RobotPace& pace,
              const ReceivingSettings& settings = {});

}  // namespace fulbito
