#pragma once

#include "fulbito/models.hpp"

namespace fulbito {

/// Contact properties of a body.
struct Surface {
  /// In order of precedence: for two different kinds, the values of the later one apply.
  enum class Kind { kWall, kObstacle, kRobot, kBall };
  Kind kind = Kind::kWall;
  double friction = 0.2;
  double restitution = 0.1;
  double hard_restitution = 0.1;  ///< restitution against walls and its own kind
};

/// Friction coefficient and restitution of a pair.
struct PairSurface {
  double friction;
  double restitution;
};

Surface surfaceOf(const RobotModel& robot);
Surface surfaceOf(const BallModel& ball);
PairSurface pairOf(const Surface& a, const Surface& b);

}  // namespace fulbito
