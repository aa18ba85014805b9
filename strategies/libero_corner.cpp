#include "strategies/libero_corner.hpp"

#include <cmath>

#include "engine/core/math.hpp"
#include "strategies/libero_motion.hpp"

namespace fulbito::libero {
namespace {

constexpr double kNear = 0.13;    // [m] of the ball, from where it is pushed along its wall
constexpr double kRival = 0.30;   // [m] of the ball: once an opponent is nearer than that, time counts
constexpr double kBehind = 0.02;  // [m] behind the ball, where a robot that races drives at
constexpr double kRolls = 0.8;    // [m/s] a faster ball is not to be pushed
constexpr double kLies = 0.3;     // [m/s]
constexpr double kAlong = 0.06;   // [m] along the wall before the ball, at which its pusher drives
constexpr double kAround = 0.15;  // [m] the same just before the corner's cut, round which it has to come
constexpr double kCut = 0.11;     // [m] from the side wall, where that begins

/// Whether the ball lies slower than `speed` at a wall of our half, with us behind it and an opponent near.
bool isFoughtFor(const Picture& picture, Vec2 rel, const Aim& aim, double speed) {
  const BallState& ball = picture.ball.now();
  return aim.wall && ball.position.x < 0.0 && dot(rel, aim.direction) > 0.0 &&
         squaredNorm(ball.velocity) < speed * speed && picture.opponentsNear(ball.position, kRival) > 0;
}

}  // namespace

bool racesAlongWall(const Picture& picture, Vec2 rel, const Aim& aim) {
  return isFoughtFor(picture, rel, aim, kLies);
}

Twist raceAlongWall(const Picture& picture, const RobotState& self, const Aim& aim) {
  return passThrough(picture.pitch, self, aim.contact - aim.direction * kBehind, picture.pitch.speed);
}

bool squeezes(const Picture& picture, Vec2 rel, const Aim& aim) {
  return squaredNorm(rel) < kNear * kNear && isFoughtFor(picture, rel, aim, kRolls);
}

Twist squeeze(const Picture& picture, const RobotState& self, Vec2 rel, const Aim& aim) {
  const Pitch& pitch = picture.pitch;
  const bool beside = aim.direction.x > 0.9;  // at the side wall
  const bool turns = !beside && std::abs(picture.ball.now().position.y) > pitch.half_width - kCut;
  const Vec2 to = rel + aim.direction * (turns ? kAround : kAlong);
  return alongHeading(pitch, self, math::angleOf(to), pitch.speed);
}

}  // namespace fulbito::libero
