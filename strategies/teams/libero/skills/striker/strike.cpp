#include <algorithm>

#include "engine/core/models/field_places.hpp"
#include "strategies/teams/libero/attack/blow.hpp"
#include "strategies/teams/libero/motion/approach.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

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
  move.twist = driveThrough(pitch, self, aim.contact, aim.direction, round, now.velocity, memory.strike.side);
  move.place = insideWalls(pitch.field, aim.contact - aim.direction * pitch.front, pitch.robot_half);
  move.target =
      aim.wall ? insideWalls(pitch.field, shot.ball + aim.direction * pitch.around, 0.0) : shot.target;
  return move;
}

}  // namespace fulbito::libero::striker
