#pragma once

#include "strategies/teams/libero/attack/aim.hpp"
#include "strategies/teams/libero/motion/approach.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/situation/move.hpp"

namespace fulbito::libero {

/// What the striker remembers between ticks.
struct StrikerMemory {
  double target_y = 0.0;    ///< [m] y of the target on the opponents' goal line
  int side = 0;             ///< present direction round the ball: +1 counter-clockwise, -1 clockwise, 0 none
  int direction_index = 0;  ///< index of the last strike direction, see `clearStrikeDirection`
  double spin_left = 0.0;   ///< [s] left of the present spin
  double spin_sense = 1.0;
  double locked = 0.0;    ///< [s] until the next spin may begin
  double jammed = 0.0;    ///< [s] time that robot and ball have pressed without motion
  double caught = 0.0;    ///< [s] time that the robot has not moved although it is away from the ball
  double freeing = 0.0;   ///< [s] left of driving off
  double slipping = 0.0;  ///< [s] left of letting a pinched ball slip out
};

/// When and where `robot` can reach the ball.
struct Interception {
  double time = 0.0;  ///< [s]
  Vec2 ball;          ///< [m] the ball's position then
};

/// The first time at which the robot can be behind the predicted ball.
Interception interception(const Picture& picture, const RobotState& robot);

/// Whether a free ball is still disputed. Then its taker only drives at the ball.
bool disputesFreeBall(const Observation& seen);

/// The striker's move: intercept the ball, drive round it and push it into the goal.
Move strike(const Picture& picture, int robot, StrikerMemory& memory);

}  // namespace fulbito::libero
