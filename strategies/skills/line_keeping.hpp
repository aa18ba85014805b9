#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// A keeper's motion on its line, a parallel of the goal line, to the y of `place`. The body is along the
/// line with either end ahead. Empty if the robot is too far off the line (`place.x`); then a navigator
/// drives it back first.
std::optional<Twist> keepLine(const RobotState& robot, Vec2 place, double max_speed);

}  // namespace fulbito
