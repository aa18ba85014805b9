#include "strategies/teams/libero/motion/motion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/math.hpp"

namespace fulbito::libero {
namespace {

constexpr double kHeldSpeed = 0.3;   // [m/s] above which an end keeps leading
constexpr double kHeldAngle = 0.26;  // [rad] beyond a right angle

/// The speed from which one can still stop in `way` [m], with a reserve.
double stoppingSpeed(const Pitch& pitch, double way) {
  return std::sqrt(2.0 * 0.75 * pitch.acceleration * std::max(0.0, way));
}

/// atan(s / c) for s, c >= 0 by a polynomial, within 0.004 rad: good enough for a time, and cheap.
double foldedAngle(double s, double c) {
  const auto arc = [](double z) { return z * (math::kPi / 4 + 0.273 * (1.0 - z)); };
  return s < c ? arc(s / c) : math::kPi / 2 - arc(c / s);
}

}  // namespace

double foldedError(double wanted, double heading) {
  const double error = math::wrapAngle(wanted - heading);
  if (error > math::kPi / 2) return error - math::kPi;
  if (error < -math::kPi / 2) return error + math::kPi;
  return error;
}

double timeToReach(const Pitch& pitch, const RobotState& robot, Vec2 target) {
  return timeToReach(pitch, robot, math::unit(robot.pose.heading), target);
}

double timeToReach(const Pitch& pitch, const RobotState& robot, Vec2 face, Vec2 target) {
  const Vec2 way = target - robot.pose.position;
  const double d = norm(way);
  if (d < 0.01) return 0.0;
  const Vec2 to = way / d;
  const double turn =
      1.4 * std::sqrt(foldedAngle(std::abs(cross(face, to)), std::abs(dot(face, to))) / pitch.turning);
  const double v0 = std::clamp(dot(robot.velocity, to), -pitch.speed, pitch.speed);
  const double a = pitch.acceleration, v = pitch.speed;
  if (v0 < 0.0) {
    const double back = v0 * v0 / (2 * a);
    const double far = d + back;
    const double run = far < v * v / (2 * a) ? std::sqrt(2 * far / a) : far / v + v / (2 * a);
    return turn - v0 / a + run;
  }
  const double ramp = (v * v - v0 * v0) / (2 * a);
  if (d < ramp) return turn + (std::sqrt(v0 * v0 + 2 * a * d) - v0) / a;
  return turn + (v - v0) / a + (d - ramp) / v;
}

Twist alongHeading(const Pitch&, const RobotState& robot, double heading, double speed,
                   const Steering& steering) {
  double error = math::wrapAngle(heading - robot.pose.heading);
  const double forward = dot(robot.velocity, math::unit(robot.pose.heading));
  double limit = math::kPi / 2;
  if (forward > kHeldSpeed) limit += kHeldAngle;
  if (forward < -kHeldSpeed) limit -= kHeldAngle;
  double sign = 1.0;
  if (std::abs(error) > limit) {
    error += error > 0.0 ? -math::kPi : math::kPi;
    sign = -1.0;
  }
  const double c = std::max(0.0, math::cos(error));
  const double slowed = steering.slow_down > 1.5 ? c * c : c;
  return {sign * speed * slowed, std::clamp(steering.gain * error, -24.0, 24.0)};
}

double fastestTurn(const Pitch& pitch, double angle) {
  return std::min(std::sqrt(2.0 * 0.6 * pitch.acceleration / pitch.half_track * angle), 25.0 * angle);
}

Twist turnTo(const Pitch& pitch, const RobotState& robot, double heading) {
  const double error = foldedError(heading, robot.pose.heading);
  return {0.0, std::copysign(fastestTurn(pitch, std::abs(error)), error)};
}

Twist restAt(const Pitch& pitch, const RobotState& robot, Vec2 place, double heading, double heading_from) {
  const Vec2 way = place - robot.pose.position;
  const double d = norm(way);
  if (d < heading_from) {
    Twist twist = turnTo(pitch, robot, heading);
    const Vec2 local = intoFrame(math::unit(robot.pose.heading), way);
    twist.linear = std::clamp(4.0 * local.x, -0.2, 0.2);
    return twist;
  }
  return alongHeading(pitch, robot, math::angleOf(way), std::min(pitch.speed, stoppingSpeed(pitch, d)));
}

Twist passThrough(const Pitch& pitch, const RobotState& robot, Vec2 place, double speed) {
  return alongHeading(pitch, robot, math::angleOf(place - robot.pose.position), speed);
}

}  // namespace fulbito::libero
