#pragma once

#include <string>

#include "fulbito/models.hpp"
#include "fulbito/world.hpp"

namespace fulbito::capture {

/// A square hall of 20 m without goals.
FieldGeometry hall();

/// Physics of the drives: the preset `standard`, but without rounding of wheel commands. A step of 0.01 rad/s
/// would be a tenth of the wheels' difference in a curve of 3.75 m at 0.1 m/s.
PhysicsProfile hallPhysics();

/// The moving object of Choi & Lee (2005), Table 2.
RobotModel objectModel();

/// A robot at a pose, driving straight ahead at `speed` [m/s].
RobotPlacement placed(const RobotModel& model, const Pose2& pose, double speed);

}  // namespace fulbito::capture
