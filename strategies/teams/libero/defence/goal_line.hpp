#pragma once

#include <optional>

#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// y [m] at which the free ball crosses the line at x = `line` [m] within the next 1.2 s; empty if it does
/// not.
std::optional<double> crossing(const Picture& picture, double line);

/// Drives along the line at `speed` [m/s]. A small turn toward the line corrects the distance from it.
Twist alongLine(const RobotState& self, double line, double speed);

/// The greatest speed [m/s] at which the robot can still stop `way` [m] ahead, at most `gain` [1/s] times
/// `way`.
double stoppableSpeed(const Pitch& pitch, double way, double gain);

/// Drives to `y` [m] on the line with the body parallel to it.
Twist slideTo(const Picture& picture, const RobotState& self, double line, double y);

}  // namespace fulbito::libero
