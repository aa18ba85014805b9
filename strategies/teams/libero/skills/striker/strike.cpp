#include <algorithm>

#include "engine/core/models/field_places.hpp"
#include "strategies/teams/libero/attack/blow.hpp"
#include "strategies/teams/libero/motion/approach.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// The most speed [m/s] of a strike. A robot that pushes the ball along their end wall while no opponent is
/// near keeps to a speed with which it can turn with the ball into the mouth: in a quarter turn, it drives
/// the way from its centre to the ball's. A faster push sends the ball past the mouth. Never slower than the
/// ball, which would leave the robot behind.
double mostSpeed(const Picture& picture, int robot, Vec2 direction) {
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const bool at_their_end =
      isAtWall(pitch, ball.position) && ball.position.x > pitch.half_length - pitch.robot_corner;
  if (!at_their_end || norm(picture.ballFrom(robot)) > pitch.touch + pitch.ball_radius ||
      picture.opponentsNear(ball.position, picture.tuning.rival_near) > 0)
    return pitch.speed;
  const double turning = pitch.front / pitch.turn_time;
  return std::min(pitch.speed, std::max(turning, dot(direction, ball.velocity)));
}

/// Lateral per forward distance within which the robot follows the line behind the ball. With an opponent
/// near, an early strike is worth more than an exact one. But in a jam, a robot that does not drive round the
/// ball holds it.
double coneFor(const Picture& picture, int robot) {
  const Vec2 ball = picture.ball.now().position;
  const double touch = picture.pitch.touch;
  if (!picture.pitch.shoves || picture.opponentsNear(ball, picture.tuning.rival_far) == 0)
    return picture.tuning.cone;
  const bool jams = norm(picture.ballFrom(robot)) < touch && picture.opponentsNear(ball, touch) > 0;
  return jams ? picture.tuning.cone : picture.tuning.wide_cone;
}

}  // namespace

std::optional<Move> strike(const Picture& picture, int robot, Memory& memory) {
  const Tuning& tuning = picture.tuning;
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const BallState& now = picture.ball.now();
  const Shot& shot = shotOf(picture, robot, memory.shot);
  Aim aim = shot.aim;
  if (!aim.wall) aim.direction = blowInTime(pitch, self.pose.position, aim, now.velocity);
  if (norm(picture.ballFrom(robot)) < tuning.rival_far)
    aim.direction = clearStrikeDirection(picture, robot, aim, memory.strike.direction);
  const int crowd = std::min(2, picture.opponentsNear(now.position, pitch.bodies + pitch.front));
  const double round = roundRadius(pitch, aim.contact.x) + crowd * roundGap(pitch, aim.contact.x);
  Move move{.reason = aim.wall ? "along the wall" : "at the widest gap", .ball = shot.ball};
  move.twist = driveThrough(pitch, self, aim.contact, aim.direction, round, coneFor(picture, robot),
                            now.velocity, memory.strike.side);
  const double most = mostSpeed(picture, robot, aim.direction);
  move.twist.linear = std::clamp(move.twist.linear, -most, most);
  move.place = insideWalls(pitch.field, aim.contact - aim.direction * pitch.front, pitch.robot_half);
  move.target =
      aim.wall ? insideWalls(pitch.field, shot.ball + aim.direction * pitch.around, 0.0) : shot.target;
  return move;
}

}  // namespace fulbito::libero::striker
