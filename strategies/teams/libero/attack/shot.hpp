#pragma once

#include <optional>

#include "strategies/teams/libero/attack/aim.hpp"

namespace fulbito::libero {

/// What the striker wants to do with the ball in this tick.
struct Shot {
  Vec2 ball;    ///< [m] where the robot will touch the ball
  Vec2 target;  ///< [m] where on the opponents' goal line it should go
  Aim aim;      ///< how to hit it for that
};

/// What a robot's shots remember between ticks.
struct ShotMemory {
  double target_y = 0.0;    ///< [m] y of the last target
  std::optional<Shot> now;  ///< the shot of this tick, once a skill has asked for it
};

/// Where [m] the robot will touch the ball.
Vec2 shotBall(const Picture& picture, int robot);

/// The robot's shot in this tick. The first skill that asks computes it; the play book forgets it with each
/// tick.
const Shot& shotOf(const Picture& picture, int robot, ShotMemory& memory);

}  // namespace fulbito::libero
