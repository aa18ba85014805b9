#pragma once

#include "fulbito/models.hpp"

namespace fulbito {

/// The speed and acceleration of a robot, for estimates of time.
struct RobotPace {
  double speed = 1.2;         ///< [m/s] top speed
  double acceleration = 6.0;  ///< [m/s^2] of the body: the smaller limit of motors and grip
  double braking = 7.0;       ///< [m/s^2] deceleration of the body: the smaller limit of motors and grip
  double turning = 289.0;     ///< [rad/s^2] in place

  RobotPace() = default;
  explicit RobotPace(const RobotModel& robot);
};

/// Least time [s] over `distance` [m] with `speed` [m/s] toward the target at the start (negative: away from
/// it), without a stop at the end.
double timeAlong(const RobotPace& pace, double distance, double speed);

/// The way [m] that a robot covers from rest in `time` [s]: the inverse of `timeAlong`.
double wayFromRest(const RobotPace& pace, double time);

/// An upper bound of the way [m] to targets that `timeToReach` allows a robot with `speed` [m/s], in whatever
/// direction, in `time` [s] >= 0. It takes less time, so callers sort out far targets with it.
double farthestIn(const RobotPace& pace, double speed, double time);

/// Time [s] of a turn in place by `angle` [rad] >= 0 from rest to rest.
double timeToTurn(const RobotPace& pace, double angle);

/// Angle [rad] in [0, pi/2] between two lines, from sine and cosine of the angle between them, not both 0. It
/// is a polynomial within 0.004 rad (Rajan et al. 2006, "Efficient approximations for the arctangent
/// function", eq. 8). Teams estimate many times per tick.
double foldedAngle(double sine, double cosine);

/// The part of a robot's state that time estimates use. Callers make it once for many estimates.
struct Runner {
  Vec2 position;  ///< [m]
  Vec2 facing;    ///< unit vector of its heading
  Vec2 velocity;  ///< [m/s]
  double speed;   ///< [m/s]

  explicit Runner(const RobotState& robot);
};

/// @{ Time [s] that a robot needs to `target` (docs/skills.md). It turns its nearer end toward the target and
/// drives through without a stop. The estimate includes its present velocity.
double timeToReach(const RobotPace& pace, const RobotState& robot, Vec2 target);
double timeToReach(const RobotPace& pace, const Runner& robot, Vec2 target);
/// @}

/// Time [s] over `distance` [m] from rest, after a turn of the leading end by `angle` [rad] >= 0.
double timeToReach(const RobotPace& pace, double distance, double angle);

}  // namespace fulbito
