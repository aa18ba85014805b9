#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito {

/// Receiving a rolling ball: the robot comes behind it, along its way, at its speed, so that it may have the
/// ball without a knock. The idea is the last part of a capture by Choi & Lee (2005): same line, same
/// heading, same speed (docs/skills.md, Receiving).
struct ReceivingSettings {
  double standoff = 0.055;    ///< [m] from the ball's middle to the robot's: the place behind it
  double detour = 0.10;       ///< [m] beside the ball's way, past a ball that the robot is in front of
  double gain = 3.0;          ///< [1/s] of the distance from the place that becomes speed
  double yaw_gain = 10.0;     ///< [1/s]
  double least_speed = 0.05;  ///< [m/s] a slower ball has no direction: the robot's own counts
};

/// The place [m] that the robot aims at now: behind the ball, or beside its way while the robot is in front.
Vec2 receivingPlace(const RobotState& robot, const BallState& ball, const ReceivingSettings& settings = {});

/// Drives the robot there with the ball's velocity added, so that both agree at the place. It moves with the
/// nearer end ahead.
Twist receive(const RobotState& robot, const BallState& ball, const RobotPace& pace,
              const ReceivingSettings& settings = {});

}  // namespace fulbito
