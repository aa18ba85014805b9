#pragma once

#include <optional>

#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// y [m] at which the free ball soon crosses the line at x = `line` [m], if it does.
std::optional<double> crossing(const Picture& picture, double line);

/// Along the line at `speed` [m/s], with a small lean that brings the robot back onto it while it moves.
Twist alongLine(const RobotState& self, double line, double speed);

/// The speed [m/s] toward a place `way` [m] off at which the robot can still stop there; `gain` [1/s].
double stoppableSpeed(const Pitch& pitch, double way, double gain);

/// To `y` [m] on the line; the body stays parallel to it.
Twist slideTo(const Picture& picture, const RobotState& self, double line, double y);

}  // namespace fulbito::libero
