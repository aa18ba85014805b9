#include "strategies/teams/libero/motion/approach.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::libero {
namespace {

/// The speed [m/s] with which a robot enters the circle round the ball: in a quarter turn, it drives the
/// circle's radius.
double enteringSpeed(const Pitch& pitch) { return pitch.around / pitch.turn_time; }

/// The speed [m/s] of a robot `distance` [m] from the ball that is about to enter the circle round it. At
/// full speed it would slide past the ball and have to come back.
double arrivingSpeed(const Pitch& pitch, double distance) {
  const double way = std::max(0.0, distance - pitch.around);
  return std::min(pitch.speed, stoppingSpeed(pitch.plannedBraking(), way, enteringSpeed(pitch)));
}

/// How far off the middle of the face [m] the ball may lie. The face sends it straight on wherever it lies,
/// so a robot that has it keeps the direction, and drives to its middle only where it is about to leave the
/// face. At a wall, the robot drives along the wall instead.
double slackOnFace(const Pitch& pitch, Vec2 contact) {
  return wallClearance(pitch.field, contact) > pitch.robot_corner ? pitch.robot_half / 2 : 0.0;
}

/// The robot turned on for a tick, as a command finds it that follows from what is seen now. Steering by the
/// heading that is seen swings about its way, and the motors that turn it to and fro are missing for speed.
RobotState turnedOn(const Pitch& pitch, RobotState self) {
  self.pose.heading += self.angular_velocity * pitch.tick;
  return self;
}

/// The mean yaw rate [rad/s] of a quarter turn.
double meanTurn(const Pitch& pitch) { return math::kPi / 2 / pitch.turn_time; }

/// `heading` [rad], turned along a wall or out of a goal mouth if it would lead the robot into it. A robot
/// that a wall or post keeps from turning would stand still.
double alongWalls(const Pitch& pitch, Vec2 robot, double heading) {
  const double gap = pitch.tuning.clearance;
  const Vec2 way = math::unit(heading) * pitch.front;
  const Vec2 kept = insideWalls(pitch.field, robot + way, pitch.robot_half + gap) - robot;
  constexpr double kRounding = 1e-8;  // [m^2] rounding
  if (squaredNorm(kept) < gap * gap || squaredNorm(kept - way) < kRounding) return heading;
  return math::angleOf(kept);
}

/// The widest gap [m] on the way round a ball.
double widestGap(const Pitch& pitch) {
  const double speed = enteringSpeed(pitch);
  return std::min(speed * speed / (2 * pitch.braking), pitch.robot_half);
}

/// Whether a robot that drove straight on would send the ball into its own goal.
bool wouldScoreAtHome(const Pitch& pitch, Vec2 robot, Vec2 ball) {
  const Vec2 way = ball - robot;
  if (way.x >= 0.0) return false;
  return std::abs(ball.y - way.y / way.x * (pitch.half_length + ball.x)) < pitch.goal_half;
}

}  // namespace

double roundGap(const Pitch& pitch, double x) {
  const double part = std::clamp((1.0 + x / pitch.half_length) / 2, 0.0, 1.0);
  return std::max(pitch.tuning.clearance, part * widestGap(pitch));
}

double roundRadius(const Pitch& pitch, double x) { return pitch.touch + roundGap(pitch, x); }

double tangentAngle(double radius, double away) {
  return away > radius ? math::asin(radius / away) : math::kPi / 2 * (2.0 - away / radius);
}

double approachHeading(const Pitch& pitch, Vec2 robot, Vec2 contact, double direction, double radius,
                       int& side) {
  const Vec2 way = contact - robot;
  const double d = norm(way);
  const double bearing = math::angleOf(way);
  const double alpha = math::wrapAngle(bearing - direction);
  int turn = alpha < 0.0 ? -1 : 1;
  if (std::abs(alpha) > math::kPi - pitch.tuning.turn_in && side != 0) turn = side;
  side = turn;
  return bearing + turn * std::min(pitch.tuning.sharpness * std::abs(alpha), tangentAngle(radius, d));
}

Twist driveThrough(const Pitch& pitch, const RobotState& self, Vec2 contact, Vec2 direction, double round,
                   double cone, Vec2 rolling, int& side) {
  const Tuning& tuning = pitch.tuning;
  const Vec2 ahead = self.pose.position + self.velocity * tuning.look_ahead;
  const Vec2 local = intoFrame(direction, ahead - contact);
  const double along = math::angleOf(direction), behind = -local.x;
  const double least = pitch.ball_radius + tuning.clearance;
  if (behind < least || std::abs(local.y) > cone * behind) {
    if (wouldScoreAtHome(pitch, self.pose.position, contact))
      round = std::max(round, pitch.touch + widestGap(pitch));
    const double heading = approachHeading(pitch, ahead, contact, along,
                                           behind < least ? round : roundRadius(pitch, contact.x), side);
    const Vec2 way = contact - self.pose.position;
    const bool comes_round = squaredNorm(rolling) < tuning.lies * tuning.lies &&
                             std::abs(math::wrapAngle(math::angleOf(way) - along)) > tuning.turn_in;
    const double led = alongWalls(pitch, self.pose.position, heading);
    return alongHeading(pitch, turnedOn(pitch, self), led,
                        comes_round ? arrivingSpeed(pitch, norm(way)) : pitch.speed,
                        turnGain(pitch, self, norm(way)));
  }
  side = 0;
  const double to_touch = std::max(0.0, behind - pitch.front);
  const double carrot = std::max(2 * pitch.ball_radius, to_touch / 2);
  const double slack = to_touch < tuning.clearance ? slackOnFace(pitch, contact) : 0.0;
  const double off = std::copysign(std::max(0.0, std::abs(local.y) - slack), local.y);
  const double heading = along - math::atan2(off, carrot);
  const double skew = std::abs(foldedError(along, self.pose.heading));
  const double needed = skew / meanTurn(pitch) + std::abs(local.y) / tuning.side_rate;
  // The touch is faster than the ball. A robot that follows the ball at its speed cannot touch it again to
  // correct its direction.
  const double touch = tuning.touch_speed + tuning.carried * std::max(0.0, dot(rolling, direction));
  const double speed =
      std::min(pitch.speed, touch + (to_touch + pitch.ball_radius) / std::max(needed, pitch.tick));
  if (to_touch < tuning.clearance) return alongHeading(pitch, self, heading, speed, tuning.push_gain);
  return alongHeading(pitch, turnedOn(pitch, self), heading, speed, turnGain(pitch, self, to_touch));
}

}  // namespace fulbito::libero
