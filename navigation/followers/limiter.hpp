#pragma once

#include "fulbito/models.hpp"

namespace fulbito {

/// Motion of the robot's body: forward speed and yaw rate.
Twist bodyTwist(const RobotState& state);

/// A copy of the robot model for teams' twists: its wheels change speed no faster in a turn than straight
/// ahead. Turns at the full acceleration of the motors would throw off a ball that the robot pushes.
RobotModel steady(RobotModel robot);

/// Yaw-priority acceleration limiter (docs/followers.md): the acceleration of one tick goes to the yaw rate
/// first, and the forward speed gets the share that is left. Then wheel saturation keeps the yaw rate and
/// lowers the speed. Without the limiter both wheels would saturate during acceleration, and the robot could
/// not steer.
Twist limitTwist(const RobotModel& robot, Twist current, Twist wanted, double dt);

}  // namespace fulbito
