#include <algorithm>

#include "engine/core/models/field_places.hpp"
#include "strategies/teams/libero/attack/blow.hpp"
#include "strategies/teams/libero/motion/approach.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

std::optional<Move> strike(const Picture& picture, int robot, Memory& memory) {
  constexpr double kCrowd = 0.16;      // [m] opponents nearer than this to the ball are in the way
  constexpr double kRoundMore = 0.03;  // [m] of radius for each of two such opponents
  constexpr double kNear = 0.35;       // [m] from here bodies in the way matter
  constexpr double kRunUp = 0.065;     // [m] from the ball's centre to the striker's when they touch
  constexpr double kAlongWall = 0.15;  // [m] length of the drawn line of a ball that is sent along a wall
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const BallState& now = picture.ball.now();
  const Shot& shot = shotOf(picture, robot, memory.shot);
  Aim aim = shot.aim;
  if (!aim.wall) aim.direction = blowInTime(self.pose.position, aim, now.velocity);
  if (squaredNorm(picture.ballFrom(robot)) < kNear * kNear)
    aim.direction = clearStrikeDirection(picture, robot, aim, memory.strike.direction);
  const double round = kRound + kRoundMore * std::min(2, picture.opponentsNear(now.position, kCrowd));
  Move move{.reason = aim.wall ? "along the wall" : "at the widest gap", .ball = shot.ball};
  move.twist = driveThrough(pitch, self, aim.contact, aim.direction, round, now.velocity, memory.strike.side);
  move.place = insideWalls(pitch.field, aim.contact - aim.direction * kRunUp, pitch.robot_half);
  move.target =
      aim.wall ? insideWalls(pitch.field, shot.ball + aim.direction * kAlongWall, 0.0) : shot.target;
  return move;
}

}  // namespace fulbito::libero::striker
