#include "strategies/teams/libero/attack/press.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {

Vec2 firstTouch(const Picture& picture) {
  const Vec2 ball = picture.ball.now().position;
  if (picture.seen.restart != RestartKind::kFreeBall || !picture.pitch.isLarge() || !picture.pitch.shoves)
    return ball;
  return ball - Vec2{0.0, std::copysign(picture.pitch.ball_radius, ball.y)};
}

bool isStandOff(const Picture& picture, Vec2 rel, const Aim& aim) {
  const double near = norm(rel);
  if (picture.pitch.shoves || aim.wall || near > picture.pitch.touch || dot(rel, aim.direction) < 0.5 * near)
    return false;
  const Vec2 opposite = picture.ball.now().position + unitOr(rel, {}) * picture.pitch.front;
  return picture.opponentsNear(opposite, picture.pitch.ball_radius + picture.tuning.clearance) > 0;
}

bool keeperTookFreeBall(const Picture& picture) {
  return !picture.pitch.shoves && picture.disputesFreeBall() && picture.ball.now().position.x > 0.0 &&
         !picture.hasOpponent(true);
}

bool touchesFreeBall(const Picture& picture, Vec2 rel) {
  const double reach = picture.pitch.front + picture.tuning.body_gap;
  return squaredNorm(rel) < reach * reach && rel.x > 0.5 * norm(rel) && keeperTookFreeBall(picture);
}

Twist holdBall(const Picture& picture, int robot) {
  const Pitch& pitch = picture.pitch;
  const Vec2 rel = picture.ballFrom(robot);
  const Vec2 place = picture.ball.now().position - unitOr(rel, {1.0, 0.0}) * pitch.front;
  return restAt(pitch, picture.own(robot), place, math::angleOf(rel), pitch.touch);
}

void watchJam(const Picture& picture, int robot, PressMemory& memory) {
  const double slow = picture.tuning.lies / 2, touch = picture.pitch.touch;
  const bool stand = squaredNorm(picture.ball.now().velocity) < slow * slow &&
                     squaredNorm(picture.own(robot).velocity) < slow * slow;
  const bool near = squaredNorm(picture.ballFrom(robot)) < touch * touch;
  memory.jammed = stand && near ? memory.jammed + picture.seen.dt : 0.0;
}

Twist pressOn(const Picture& picture, int robot, PressMemory& memory) {
  const RobotState& self = picture.own(robot);
  if (memory.jammed > picture.tuning.jam_time) memory.slipping = true;
  if (!memory.slipping) return passThrough(picture.pitch, self, firstTouch(picture));
  const double out = std::copysign(picture.tuning.slant, picture.ball.now().position.y);
  return alongHeading(picture.pitch, self, math::angleOf(picture.ballFrom(robot)) + out, picture.pitch.speed);
}

}  // namespace fulbito::libero
