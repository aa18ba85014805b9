#pragma once

#include "fulbito/models.hpp"

namespace fulbito {

/// How fast a robot is, in the few numbers that estimates need.
struct RobotPace {
  double speed = 1.2;         ///< [m/s] top speed
  double acceleration = 6.0;  ///< [m/s^2] of the body: the lesser of motors and grip
  double turning = 289.0;     ///< [rad/s^2] in place

  RobotPace() = default;
  explicit RobotPace(const RobotModel& robot);
};

/// Least time [s] over `distance` [m] with `speed` [m/s] toward the target at the start (negative: away from
/// it), without a stop at the end.
double timeAlong(const RobotPace& pace, double distance, double speed);

/// Time [s] of a turn in place by `angle` [rad] >= 0 from rest to rest.
double timeToTurn(const RobotPace& pace, double angle);

/// Angle [rad] in [0, pi/2] between two lines from sine and cosine of the angle between them, not both 0:
/// within 0.004 rad by a polynomial (Rajan et al. 2006, "Efficient approximations for the arctangent
/// function", eq. 8), for estimates that are made many times a tick.
double foldedAngle(double sine, double cosine);

/// A robot as estimates of time see it; made once when many are made.
struct Runner {
  Vec2 position;  ///< [m]
  Vec2 facing;    ///< unit
  Vec2 velocity;  ///< [m/s]
};

/// @{ Time [s] in which a robot comes to `target` (docs/skills.md): it turns whichever end is nearer toward
/// it and drives through, the speed that it has counts.
double timeToReach(const RobotPace& pace, const RobotState& robot, Vec2 target);
double timeToReach(const RobotPace& pace, const Runner& robot, Vec2 target);
/// @}

/// The same over `distance` [m] from rest, after a turn by `angle` [rad] >= 0 of the end that leads.
double timeToReach(const RobotPace& pace, double distance, double angle);

}  // namespace fulbito
