#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Wheel speeds for `wanted` that use all of the motors: the robot turns with the acceleration of its model,
/// brakes with that of braking, and speeds up with what the turn leaves. `dt` [s] is the control period.
/// `RobotCommand::byTwist` is gentler: it brakes no harder than it speeds up.
RobotCommand quickTwist(const RobotModel& model, const RobotState& robot, Twist wanted, double dt);

}  // namespace fulbito
