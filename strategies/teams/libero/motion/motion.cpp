#include "strategies/teams/libero/motion/motion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito::libero {
namespace {

/// Whether the rear end of a robot leads on a way that is `error` [rad] >= 0 off its heading. Its motion only
/// counts where the turns of both ends are nearly equal.
bool leadsWithRear(const Pitch& pitch, const RobotState& robot, double error) {
  const double keeps = pitch.tuning.turn_in / 2, equal = math::kPi / 2;
  if (error <= equal - keeps) return false;
  if (error > equal + keeps) return true;
  const double forward = dot(robot.velocity, math::unit(robot.pose.heading));
  if (std::abs(forward) > pitch.tuning.lies) return error > equal + std::copysign(keeps, forward);
  return error > equal;
}

}  // namespace

double foldedError(double wanted, double heading) {
  const double error = math::wrapAngle(wanted - heading);
  if (error > math::kPi / 2) return error - math::kPi;
  if (error < -math::kPi / 2) return error + math::kPi;
  return error;
}

Twist alongHeading(const Pitch& pitch, const RobotState& robot, double heading, double speed, double gain) {
  double error = math::wrapAngle(heading - robot.pose.heading);
  double sign = 1.0;
  if (leadsWithRear(pitch, robot, std::abs(error))) {
    error += error > 0.0 ? -math::kPi : math::kPi;
    sign = -1.0;
  }
  const double c = std::max(0.0, math::cos(error));
  return {sign * speed * (c * c), std::clamp(gain * error, -pitch.turn_rate, pitch.turn_rate)};
}

double turnGain(const Pitch& pitch, const RobotState& robot, double way) {
  if (pitch.shoves) return pitch.tuning.turn_gain;
  // The error falls with the cube of the time left, the lowest power for which both the turn and the motors'
  // pull on it end at the place.
  const double time = timeAlong(pitch.pace, way, norm(robot.velocity));
  return std::min(pitch.tuning.turn_gain, 3 / std::max(time, pitch.tick));
}

Twist alongHeading(const Pitch& pitch, const RobotState& robot, double heading, double speed) {
  return alongHeading(pitch, robot, heading, speed, pitch.tuning.turn_gain);
}

double fastestTurn(const Pitch& pitch, double angle) {
  return std::min(stoppingSpeed(pitch.plannedTurning(), angle), pitch.tuning.rest_gain * angle);
}

Twist turnTo(const Pitch& pitch, const RobotState& robot, double heading) {
  const double error = foldedError(heading, robot.pose.heading);
  return {0.0, std::copysign(fastestTurn(pitch, std::abs(error)), error)};
}

double creeping(const Pitch& pitch, double way) {
  return std::clamp(pitch.tuning.push_gain * way, -pitch.tuning.lies, pitch.tuning.lies);
}

Twist restAt(const Pitch& pitch, const RobotState& robot, Vec2 place, double heading, double heading_from) {
  const Vec2 way = place - robot.pose.position;
  const double d = norm(way);
  if (d < heading_from) {
    Twist twist = turnTo(pitch, robot, heading);
    const Vec2 local = intoFrame(math::unit(robot.pose.heading), way);
    twist.linear = creeping(pitch, local.x);
    return twist;
  }
  return alongHeading(pitch, robot, math::angleOf(way),
                      std::min(pitch.speed, stoppingSpeed(pitch.plannedBraking(), d)));
}

Twist passThrough(const Pitch& pitch, const RobotState& robot, Vec2 place) {
  const Vec2 way = place - robot.pose.position;
  return alongHeading(pitch, robot, math::angleOf(way), pitch.speed, turnGain(pitch, robot, norm(way)));
}

}  // namespace fulbito::libero
