#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/base/vec2.hpp"

namespace fulbito {

/// Control ticks since the world's creation. Seconds are `tick * dt`, never a running sum.
using Tick = std::int64_t;

/// World frame: field centre, x toward the right goal, y up.
struct Pose2 {
  Vec2 position;         ///< [m]
  double heading = 0.0;  ///< [rad] in [-pi, pi), counter-clockwise, 0 along +x
};

/// Body-frame motion of a differential-drive robot (x forward).
struct Twist {
  double linear = 0.0;   ///< [m/s] forward
  double angular = 0.0;  ///< [rad/s] counter-clockwise
};

/// Wheel rotation; positive drives forward.
struct WheelSpeeds {
  double left = 0.0;   ///< [rad/s]
  double right = 0.0;  ///< [rad/s]
};

struct RobotState {
  Pose2 pose;
  Vec2 velocity;                  ///< [m/s] world frame
  double angular_velocity = 0.0;  ///< [rad/s]
  WheelSpeeds wheels;             ///< [rad/s] encoder readings: they differ from the ground speed during slip
};

struct BallState {
  Vec2 position;
  Vec2 velocity;  ///< [m/s]
  Vec2 spin;      ///< [m/s] spin times radius: the velocity at which the ball would roll without sliding
};

struct ObstacleState {
  Pose2 pose;
  Vec2 velocity;  ///< [m/s]
};

/// Everything that moves, as a plain value. Robots are in the order of `WorldConfig::robots`.
struct WorldState {
  Tick tick = 0;
  std::vector<RobotState> robots;
  std::vector<BallState> balls;
  std::vector<ObstacleState> obstacles;
};

}  // namespace fulbito
