// Private header of strategies: not installed.
#pragma once

#include "strategies/interface/strategy.hpp"
#include "strategies/teams/libero/motion/approach.hpp"

namespace fulbito::libero {

/// One tick of a drill's task, by the skills of the game: what the first robot does.
Twist exerciseTwist(const Pitch& pitch, const RobotState& robot, Vec2 ball, const Exercise& exercise,
                    int& side);

}  // namespace fulbito::libero
