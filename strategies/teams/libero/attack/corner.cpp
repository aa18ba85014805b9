#include "strategies/teams/libero/attack/corner.hpp"

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {
namespace {

/// Whether the ball is slower than `speed` [m/s] at a wall of the own half, the robot is behind it, and an
/// opponent is within `rival` [m] of it. `rel` [m] is the ball seen from the robot.
bool isFoughtFor(const Picture& picture, Vec2 rel, const Aim& aim, double speed, double rival) {
  const BallState& ball = picture.ball.now();
  return aim.wall && ball.position.x < 0.0 && dot(rel, aim.direction) > 0.0 &&
         squaredNorm(ball.velocity) < speed * speed && picture.opponentsNear(ball.position, rival) > 0;
}

}  // namespace

bool squeezes(const Picture& picture, Vec2 rel, const Aim& aim) {
  constexpr double kReach = 0.13;  // [m]
  constexpr double kRolls = 0.8;   // [m/s] a faster ball cannot be pushed
  constexpr double kRival = 0.20;  // [m] an opponent farther from the ball leaves time to drive round it
  return squaredNorm(rel) < kReach * kReach && isFoughtFor(picture, rel, aim, kRolls, kRival);
}

Twist squeeze(const Picture& picture, const RobotState& self, Vec2 rel, const Aim& aim) {
  // [m] aim point along the wall in front of the ball. A larger value moves the ball round the corner sooner.
  // But a ball that two opponents bring down the end wall then slips between that wall and the robot.
  constexpr double kAlong = 0.06;
  const double heading = math::angleOf(rel + aim.direction * kAlong);
  return alongHeading(self, heading, picture.pitch.speed);
}

bool racesAlongWall(const Picture& picture, Vec2 rel, const Aim& aim) {
  constexpr double kLies = 0.3;   // [m/s]
  constexpr double kRival = 0.3;  // [m] an opponent nearer than this is at the ball in about 0.2 s
  return isFoughtFor(picture, rel, aim, kLies, kRival);
}

Twist raceAlongWall(const Picture& picture, const RobotState& self, const Aim& aim) {
  constexpr double kBehind = 0.02;  // [m] a push at the centre would press the ball into the wall
  return passThrough(self, aim.contact - aim.direction * kBehind, picture.pitch.speed);
}

}  // namespace fulbito::libero
