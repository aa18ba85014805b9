#include "strategies/teams/libero/motion/motion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::libero {
namespace {

constexpr double kHeldSpeed = 0.3;   // [m/s] above this speed the leading end stays
constexpr double kHeldAngle = 0.26;  // [rad] beyond a right angle; smaller errors keep the end
constexpr double kBraking = 0.75;    // share of the acceleration that a robot plans to use for braking

}  // namespace

double foldedError(double wanted, double heading) {
  const double error = math::wrapAngle(wanted - heading);
  if (error > math::kPi / 2) return error - math::kPi;
  if (error < -math::kPi / 2) return error + math::kPi;
  return error;
}

Twist alongHeading(const RobotState& robot, double heading, double speed, double gain) {
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
  return {sign * speed * (c * c), std::clamp(gain * error, -24.0, 24.0)};
}

double fastestTurn(const Pitch& pitch, double angle) {
  return std::min(stoppingSpeed(0.6 * pitch.turning, angle), 25.0 * angle);
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
  return alongHeading(robot, math::angleOf(way),
                      std::min(pitch.speed, stoppingSpeed(kBraking * pitch.braking, d)));
}

Twist passThrough(const RobotState& robot, Vec2 place, double speed) {
  return alongHeading(robot, math::angleOf(place - robot.pose.position), speed);
}

}  // namespace fulbito::libero
