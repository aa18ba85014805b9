#pragma once

#include "engine/core/physics_profile.hpp"
#include "engine/core/robot_model.hpp"
#include "replays/recording.hpp"

namespace fulbito {

/// What the header of a recording says of the commands of such robots: they gain what their motors allow in a
/// tick, and spin as their model says.
CommandModel commandModel(const RobotModel& robot, const PhysicsProfile& physics);

/// [rad/s] The step of commands in a recording; 0 where the profile has none, or one too fine to be counted
/// in whole numbers.
double recordedCommandStep(const PhysicsProfile& physics);

}  // namespace fulbito
