#pragma once

#include <optional>

#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Distance [m] between a robot's body and the ball; negative if they overlap. Empty if it is more than
/// `most`.
std::optional<double> ballGap(const RobotModel& robot, const Pose2& pose, const BallModel& ball, Vec2 place,
                              double most);

}  // namespace fulbito
