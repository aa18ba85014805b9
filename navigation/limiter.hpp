#pragma once

#include "engine/core/robot_model.hpp"

namespace fulbito {

/// Motion of the robot body as the limiter sees it: forward speed and yaw rate.
Twist bodyTwist(const RobotState& state);

/// Yaw-priority acceleration limiter (docs/followers.md): what the motors can do in one tick goes to the
/// yaw rate first and the share that is left to the forward speed; then wheel saturation keeps the yaw rate
/// and lowers the speed. Without it both wheels saturate while speeding up and the robot cannot steer.
Twist limitTwist(const RobotModel& robot, Twist current, Twist wanted, double dt);

}  // namespace fulbito
