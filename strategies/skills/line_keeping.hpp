#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Slides along a line parallel to the goal line to the height of `place`, body along the line, either end
/// ahead: what a keeper on its line does. Empty when the robot is too far off the line (`place.x`), which a
/// navigator has to mend first.
std::optional<Twist> keepLine(const RobotState& robot, Vec2 place, double max_speed);

}  // namespace fulbito
