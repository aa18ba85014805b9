#pragma once

#include "engine/core/models/physics_profile.hpp"
#include "engine/core/models/robot_model.hpp"
#include "replays/recording/recording.hpp"

namespace fulbito {

/// A header with all that follows from the world: rates, the step of commands (0 where the profile has none,
/// or one too fine to be counted in whole numbers), what is known of commands (robots gain what their motors
/// allow in a tick, and spin as their model says), and this build. Bodies and recipe are left to the caller.
RecordingHeader headerFor(RecordingKind kind, const RobotModel& robot, const PhysicsProfile& physics);

}  // namespace fulbito
