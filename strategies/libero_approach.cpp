#include "strategies/libero_approach.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math.hpp"

namespace fulbito::libero {
namespace {

constexpr double kSharpness = 2.7;    // n of the field
constexpr double kHalf = 0.03;        // [m] nearer than this is not behind
constexpr double kCone = 0.35;        // |y| / x within which the line is followed
constexpr double kLookAhead = 0.045;  // [s]
constexpr double kTurnRate = 8.0;     // [rad/s] at which skew can be taken out before the touch
constexpr double kSideRate = 0.35;    // [m/s] the same of the lateral error
constexpr double kSlowTouch = 0.5;    // [m/s]
constexpr double kPushGain = 10.0;    // [1/s]

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
                   int& side) {
  const Vec2 ahead = self.pose.position + self.velocity * kLookAhead;
  const Vec2 local = intoFrame(direction, ahead - contact);
  const double along = math::angleOf(direction);
  if (-local.x < kHalf || std::abs(local.y) > kCone * -local.x) {
    const double heading =
        approachHeading(ahead, contact, along, local.x > -0.03 ? round : kRound, kSharpness, side);
    return alongHeading(pitch, self, heading, pitch.speed);
  }
  side = 0;
  const double to_touch = std::max(0.0, -local.x - 0.06);
  const double carrot = std::max(0.045, 0.5 * to_touch);
  const double heading = along - math::atan2(local.y, carrot);
  const double skew = std::abs(foldedError(along, self.pose.heading));
  const double needed = skew / kTurnRate + std::abs(local.y) / kSideRate;
  const double speed = std::min(pitch.speed, kSlowTouch + (to_touch + 0.025) / std::max(needed, 0.01));
  Steering steering;
  steering.gain = to_touch < 0.015 ? kPushGain : 16.0;
  return alongHeading(pitch, self, heading, speed, steering);
}

}  // namespace fulbito::libero
