#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Wheel speeds for `wanted` that use all of the motors, also in a turn: `RobotCommand::byTwist` turns no
/// harder than the motors pull straight ahead, so that a pushed ball stays. The present twist is that of the
/// robot's wheels. `dt` [s] is the control period.
RobotCommand quickTwist(const RobotModel& model, const RobotState& robot, Twist wanted, double dt);

}  // namespace fulbito
