#include "strategies/skills/receiving.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

Vec2 directionOf(const RobotState& robot, const BallState& ball, const ReceivingSettings& settings) {
  if (norm(ball.velocity) >= settings.least_speed) return ball.velocity / norm(ball.velocity);
  return unitOr(ball.position - robot.pose.position, math::unit(robot.pose.heading));
}

}  // namespace

Vec2 receivingPlace(const RobotState& robot, const BallState& ball, const ReceivingSettings& settings) {
  const Vec2 along = directionOf(robot, ball, settings), from = robot.pose.position - ball.position;
  const double ahead = dot(along, from), aside = cross(along, from);
  const Vec2 behind = ball.position - along * settings.standoff;
  // A robot beside the ball can only move behind it after it has passed it.
  if (ahead < -settings.standoff / 2) return behind;
  return behind + perp(along) * std::copysign(settings.detour, aside);
}

Twist receive(const RobotState& robot, const BallState& ball, const RobotPace& pace,
              const ReceivingSettings& settings) {
  const Vec2 lack = receivingPlace(robot, ball, settings) - robot.pose.position;
  const Vec2 wanted = ball.velocity + lack * settings.gain;
  const double speed = std::min(norm(wanted), pace.speed);
  // A robot at rest behind a ball at rest turns toward it.
  const Vec2 toward = speed > 0.02 ? wanted : ball.position - robot.pose.position;
  double error = math::wrapAngle(math::angleOf(toward) - robot.pose.heading);
  const bool backward = std::abs(error) > math::kPi / 2;
  if (backward) error = math::wrapAngle(error + math::kPi);
  const math::SinCos sc = math::sinCos(error);
  return {(backward ? -speed : speed) * sc.cos * sc.cos, settings.yaw_gain * sc.sin};
}

}  // namespace fulbito
