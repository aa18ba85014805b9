#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Moves a keeper along its line, which is parallel to the goal line at `place.x`, to the y of `place`. The
/// body is parallel to the line, and either end may lead. Empty if the robot is too far off the line; then a
/// navigator must drive it back first.
std::optional<Twist> keepLine(const RobotState& robot, Vec2 place, double max_speed);

}  // namespace fulbito
