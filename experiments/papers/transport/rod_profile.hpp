#pragma once

#include <vector>

#include "experiments/papers/transport/constraint_curve.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Reference of a robot at one tick.
struct CarrierReference {
  PartPlace place;
  double speed = 0.0;  ///< [m/s] along the path
};

/// Both robots' references at one tick.
struct RodReference {
  CarrierReference lead;
  CarrierReference follower;
};

/// Limits of the robots' motion.
struct RodPace {
  double speed = 0.2;               ///< [m/s] limit for each robot along the path
  double acceleration_share = 0.5;  ///< share of the wheels' acceleration; the rest is for errors and the rod
  double bend_time = 0.1;           ///< [s] for changes of the wheels' speeds at joints
};

/// The fastest motion along the constraint curve from rest to rest, as one reference per `tick` [s]. Each
/// robot's speed, its wheels' speed and acceleration, and jumps of curvature limit its rate. Errors:
/// kBadInput for a curve that does not arrive, and for a path with corners, which no wheeled robot can follow
/// without a stop.
Result<std::vector<RodReference>> profileAlong(const TransportTask& task, const ConstraintCurve& curve,
                                               const RobotModel& robot, const RodPace& pace, double tick);

}  // namespace fulbito
