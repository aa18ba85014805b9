#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/motion/approach.hpp"

namespace fulbito::libero {

/// What the first robot remembers of a drill's task between ticks.
struct ExerciseMemory {
  bool runs_up = false;  ///< it is aligned behind the ball and runs at it
  int side = 0;          ///< way round the ball that is held, as in `approachHeading`
};

/// One tick of a drill's task, by the skills of the game: what the first robot does.
Twist exerciseTwist(const Pitch& pitch, const RobotState& robot, Vec2 ball, const Exercise& exercise,
                    ExerciseMemory& memory);

}  // namespace fulbito::libero
