#include "strategies/libero_corner.hpp"

#include <cmath>

#include "engine/core/math.hpp"
#include "strategies/libero_motion.hpp"

namespace fulbito::libero {
namespace {

constexpr double kCrowd = 0.16;   // [m] about a ball at a wall, in which opponents are in the way
constexpr double kRival = 0.30;   // [m] the same in a corner, where it is too late once they are there
constexpr double kCorner = 0.30;  // [m] from the end wall, which is a corner beside the goal area
constexpr double kBehind = 0.02;  // [m] behind the ball, where a robot that races drives at
constexpr double kLies = 0.3;     // [m/s]
constexpr double kAlong = 0.06;   // [m] along the wall before the ball, at which its pusher drives
constexpr double kAround = 0.15;  // [m] the same where the wall still turns: it has to come round the cut

bool inOwnCorner(const Pitch& pitch, Vec2 ball) {
  return ball.x < -pitch.half_length + kCorner && std::abs(ball.y) > pitch.area_half;
}

bool isBehind(Vec2 rel, const Aim& aim) { return aim.wall && dot(rel, aim.direction) > 0.0; }

}  // namespace

bool racesToCorner(const Picture& picture, Vec2 rel, const Aim& aim) {
  const BallState& ball = picture.ball.now();
  return isBehind(rel, aim) && inOwnCorner(picture.pitch, ball.position) &&
         squaredNorm(ball.velocity) < kLies * kLies && picture.opponentsNear(ball.position, kRival) > 0;
}

Twist raceToCorner(const Picture& picture, const RobotState& self, const Aim& aim) {
  return passThrough(picture.pitch, self, aim.contact - aim.direction * kBehind, picture.pitch.speed);
}

bool squeezes(const Picture& picture, Vec2 rel, const Aim& aim) {
  constexpr double kReach = 0.13, kRolls = 0.8;  // [m], [m/s]
  const BallState& ball = picture.ball.now();
  const double crowd = inOwnCorner(picture.pitch, ball.position) ? kRival : kCrowd;
  return isBehind(rel, aim) && ball.position.x < 0.0 && squaredNorm(rel) < kReach * kReach &&
         squaredNorm(ball.velocity) < kRolls * kRolls && picture.opponentsNear(ball.position, crowd) > 0;
}

Twist squeeze(const Picture& picture, const RobotState& self, Vec2 rel, const Aim& aim) {
  const bool beside = aim.direction.x > 0.9;  // at the side wall
  const bool turns = !beside && inOwnCorner(picture.pitch, picture.ball.now().position);
  const Vec2 to = rel + aim.direction * (turns ? kAround : kAlong);
  return alongHeading(picture.pitch, self, math::angleOf(to), picture.pitch.speed);
}

}  // namespace fulbito::libero
