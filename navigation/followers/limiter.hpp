#pragma once

#include "fulbito/models.hpp"

namespace fulbito {

/// Motion of the robot body as the limiter sees it: forward speed and yaw rate.
Twist bodyTwist(const RobotState& state);

/// The robot as the twists of teams count with it: its rims change no faster in place than straight on. Turns
/// as quick as the motors can make them throw off the ball that a robot pushes.
RobotModel steady(RobotModel robot);

/// Yaw-priority acceleration limiter (docs/followers.md): what the motors can do in one tick goes to the
/// yaw rate first and the share that is left to the forward speed; then wheel saturation keeps the yaw rate
/// and lowers the speed. Without it both wheels saturate while speeding up and the robot cannot steer.
Twist limitTwist(const RobotModel& robot, Twist current, Twist wanted, double dt);

}  // namespace fulbito
