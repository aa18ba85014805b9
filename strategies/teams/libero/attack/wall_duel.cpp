#include "strategies/teams/libero/attack/wall_duel.hpp"

namespace fulbito::libero {

bool isFoughtFor(const Picture& picture, Vec2 rel, const Aim& aim, double speed, double rival) {
  const BallState& ball = picture.ball.now();
  return aim.wall && dot(rel, aim.direction) > 0.0 && squaredNorm(ball.velocity) < speed * speed &&
         picture.opponentsNear(ball.position, rival) > 0;
}

bool isPressed(const Picture& picture, int robot, const Aim& aim) {
  const double reach = picture.pitch.touch + picture.pitch.front;
  const Vec2 rel = picture.ballFrom(robot);
  return squaredNorm(rel) < reach * reach &&
         isFoughtFor(picture, rel, aim, picture.tuning.pushable, picture.tuning.rival_near);
}

}  // namespace fulbito::libero
