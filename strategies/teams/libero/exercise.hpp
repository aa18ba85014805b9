#pragma once

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/motion/approach.hpp"

namespace fulbito::libero {

/// State of the first robot in a drill's task between ticks.
struct ExerciseMemory {
  bool runs_up = false;  ///< the robot is aligned behind the ball and drives at it
  int side = 0;          ///< present direction round the ball, as in `approachHeading`
};

/// One tick of a drill's task: the twist of the first robot, made with the skills of play.
Twist exerciseTwist(const Pitch& pitch, const RobotState& robot, Vec2 ball, const Exercise& exercise,
                    ExerciseMemory& memory);

}  // namespace fulbito::libero
