#pragma once

#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/attack/shot.hpp"
#include "strategies/teams/libero/motion/room.hpp"

namespace fulbito::libero {

/// What a robot's skills remember between ticks. A robot forgets it at a restart, and when it becomes
/// striker.
struct Memory {
  struct Spin {
    double left = 0.0;    ///< [s] left of the present spin
    double sense = 1.0;   ///< +1 counter-clockwise, -1 clockwise
    double locked = 0.0;  ///< [s] until the next spin may begin
  };
  struct Ram {
    double left = 0.0;  ///< [s] left of run-up and blow
    double back = 0.0;  ///< [m/s] speed of the run-up
  };
  struct Strike {
    int side = 0;       ///< present direction round the ball: +1 counter-clockwise, -1 clockwise, 0 none
    int direction = 0;  ///< index of the last strike direction, see `clearStrikeDirection`
  };

  Spin spin;
  Ram ram;
  Strike strike;
  PressMemory press;
  ShotMemory shot;
  YieldMemory yield;
  SlideMemory slide;
  double volley = 0.0;  ///< [s] until the robot meets the ball at its volley; 0: it plays none
};

}  // namespace fulbito::libero
