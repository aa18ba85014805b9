#include "strategies/teams/libero/motion/approach.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::libero {
namespace {

constexpr double kSharpness = 2.7;  // exponent n of the posture field
constexpr double kHalf = 0.03;      // [m] a robot nearer than this is not behind the ball
constexpr double kCone = 0.35;      // lateral over forward distance, within which the robot follows the line
constexpr double kLookAhead = 0.045;  // [s]
constexpr double kTurnRate = 8.0;     // [rad/s] at which the heading error can fall before the touch
constexpr double kSideRate = 0.35;    // [m/s] rate at which it can reduce its lateral error
constexpr double kSlowTouch = 0.5;    // [m/s] speed of the touch at a resting ball
constexpr double kPushGain = 10.0;    // [1/s]
constexpr double kCarried = 0.5;      // share of the ball's speed that is added to the speed of the touch
constexpr double kLies = 0.15;        // [m/s] a slower ball waits until the robot has driven round it
constexpr double kRoundSpeed = 0.49;  // [m/s] speed on the circle round the ball
constexpr double kSlowing = 4.0;      // [m/s^2] deceleration to that speed
constexpr double kArc = 0.12;         // [m] from the ball, where that speed is reached
constexpr double kTurnsOff = 0.6;     // [rad] from the way to the ball to the strike: slow beyond it

/// The speed [m/s] of a robot `distance` [m] from the ball that is about to enter the circle round it. At
/// full speed it would slide past the ball and have to come back.
double arrivingSpeed(const Pitch& pitch, double distance) {
  const double way = std::max(0.0, distance - kArc);
  return std::min(pitch.speed, stoppingSpeed(kSlowing, way, kRoundSpeed));
}

/// `heading` [rad], turned along a wall or out of a goal mouth if it would lead the robot into it. A robot
/// that a wall or post keeps from turning would stand still.
double alongWalls(const Pitch& pitch, Vec2 robot, double heading) {
  constexpr double kAhead = 0.06, kMargin = 0.045, kHere = 0.01;  // [m]
  const Vec2 to = robot + math::unit(heading) * kAhead;
  const Vec2 kept = insideWalls(pitch.field, to, kMargin) - robot;
  if (squaredNorm(kept) < kHere * kHere || squaredNorm(kept - (to - robot)) < 1e-8) return heading;
  return math::angleOf(kept);
}

}  // namespace

double approachHeading(Vec2 robot, Vec2 contact, double direction, double radius, double sharpness,
                       int& side) {
  const Vec2 way = contact - robot;
  const double d = norm(way);
  const double bearing = math::angleOf(way);
  const double alpha = math::wrapAngle(bearing - direction);
  int turn = alpha < 0.0 ? -1 : 1;
  if (std::abs(alpha) > 2.5 && side != 0) turn = side;
  side = turn;
  const double most = d > radius ? math::asin(radius / d) : math::kPi / 2 + (1.0 - d / radius) * 1.5;
  return bearing + turn * std::min(sharpness * std::abs(alpha), most);
}

Twist driveThrough(const Pitch& pitch, const RobotState& self, Vec2 contact, Vec2 direction, double round,
                   Vec2 rolling, int& side) {
  const Vec2 ahead = self.pose.position + self.velocity * kLookAhead;
  const Vec2 local = intoFrame(direction, ahead - contact);
  const double along = math::angleOf(direction);
  if (-local.x < kHalf || std::abs(local.y) > kCone * -local.x) {
    const double heading =
        approachHeading(ahead, contact, along, local.x > -0.03 ? round : kRound, kSharpness, side);
    const Vec2 way = contact - self.pose.position;
    const bool comes_round = squaredNorm(rolling) < kLies * kLies &&
                             std::abs(math::wrapAngle(math::angleOf(way) - along)) > kTurnsOff;
    const double led = alongWalls(pitch, self.pose.position, heading);
    return alongHeading(self, led, comes_round ? arrivingSpeed(pitch, norm(way)) : pitch.speed);
  }
  side = 0;
  const double to_touch = std::max(0.0, -local.x - 0.06);
  const double carrot = std::max(0.045, 0.5 * to_touch);
  const double heading = along - math::atan2(local.y, carrot);
  const double skew = std::abs(foldedError(along, self.pose.heading));
  const double needed = skew / kTurnRate + std::abs(local.y) / kSideRate;
  // The touch is faster than the ball. A robot that follows the ball at its speed cannot touch it again to
  // correct its direction.
  const double touch = kSlowTouch + kCarried * std::max(0.0, dot(rolling, direction));
  const double speed = std::min(pitch.speed, touch + (to_touch + 0.025) / std::max(needed, 0.01));
  return alongHeading(self, heading, speed, to_touch < 0.015 ? kPushGain : kTurnGain);
}

}  // namespace fulbito::libero
