#include "strategies/teams/libero/attack/wall_duel.hpp"

namespace fulbito::libero {

bool isFoughtFor(const Picture& picture, Vec2 rel, const Aim& aim, double speed, double rival) {
  const BallState& ball = picture.ball.now();
  return aim.wall && dot(rel, aim.direction) > 0.0 && squaredNorm(ball.velocity) < speed * speed &&
         picture.opponentsNear(ball.position, rival) > 0;
}

}  // namespace fulbito::libero
