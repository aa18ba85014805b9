#pragma once

#include <vector>

#include "experiments/papers/transport/constraint_curve.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Where a robot shall be at one tick.
struct CarrierReference {
  PartPlace place;
  double speed = 0.0;  ///< [m/s] along the path
};

/// Both robots' references at one tick.
struct RodReference {
  CarrierReference lead;
  CarrierReference follower;
};

/// What the robots may do on their way.
struct RodPace {
  double speed = 0.2;               ///< [m/s] of either robot along the path
  double acceleration_share = 0.5;  ///< of what the wheels can do: the rest is for errors and the rod
  double bend_time = 0.1;           ///< [s] in which the wheels may change speed where a line meets an arc
};

/// The fastest motion along the constraint curve from rest to rest: one reference per `tick` [s]. Its rate is
/// limited by each robot's speed, its wheels' speed and acceleration, and jumps of curvature. Errors:
/// kBadInput for a curve that does not arrive, and for a path with corners, where no wheeled robot keeps on.
Result<std::vector<RodReference>> profileAlong(const TransportTask& task, const ConstraintCurve& curve,
                                               const RobotModel& robot, const RodPace& pace, double tick);

}  // namespace fulbito
