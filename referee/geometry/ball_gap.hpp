// Private header of referee: not installed.
#pragma once

#include <optional>

#include "engine/core/base/values.hpp"
#include "engine/core/models/ball_model.hpp"
#include "engine/core/models/robot_model.hpp"

namespace fulbito {

/// Distance [m] between a robot's body and the ball; negative if they overlap. Empty if it is more than
/// `most`, which is found without the body's heading.
std::optional<double> ballGap(const RobotModel& robot, const Pose2& pose, const BallModel& ball, Vec2 place,
                              double most);

}  // namespace fulbito
