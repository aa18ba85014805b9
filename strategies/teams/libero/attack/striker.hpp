#pragma once

#include "strategies/teams/libero/attack/aim.hpp"
#include "strategies/teams/libero/motion/approach.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/situation/move.hpp"

namespace fulbito::libero {

/// What the striker remembers between ticks.
struct StrikerMemory {
  double target_y = 0.0;    ///< [m] y on their goal line that is aimed at
  int side = 0;             ///< way round the ball that is held: +1 counter-clockwise
  int direction_index = 0;  ///< of the strike direction chosen last tick, see `clearStrikeDirection`
  double spin_left = 0.0;   ///< [s] of a spin that is under way
  double spin_sense = 1.0;
  double locked = 0.0;    ///< [s] before the next spin
  double jammed = 0.0;    ///< [s] for which robot and ball have pressed without moving
  double caught = 0.0;    ///< [s] for which the robot has not moved, away from the ball
  double freeing = 0.0;   ///< [s] for which it still drives off what caught it
  double slipping = 0.0;  ///< [s] for which a pinched ball is still let slip
};

/// When and where `robot` can have the ball.
struct Interception {
  double time = 0.0;  ///< [s]
  Vec2 ball;          ///< [m] where the ball then is
};

/// First time at which the robot can be behind the predicted ball.
Interception interception(const Picture& picture, const RobotState& robot);

/// Whether a free ball is still disputed: its taker drives at the ball, and nothing else.
bool disputesFreeBall(const Observation& seen);

/// The striker's way: intercept, come round, push it in.
Move strike(const Picture& picture, int robot, StrikerMemory& memory);

}  // namespace fulbito::libero
