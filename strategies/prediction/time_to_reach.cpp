#include "strategies/prediction/time_to_reach.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kShareOfTurn = 0.7;  // share of a turn made in place; the rest is made while driving

}  // namespace

RobotPace::RobotPace(const RobotModel& robot)
    : speed(robot.maxSpeed()),
      acceleration(std::min(robot.wheel_acceleration, robot.longitudinal_grip)),
      braking(robot.braking()),
      turning(robot.turnAcceleration()) {}

double timeAlong(const RobotPace& pace, double distance, double speed) {
  const double v = pace.speed, a = pace.acceleration;
  if (speed < 0.0) {
    // The robot brakes first, then drives the braking distance again in the other direction.
    const double b = pace.braking;
    return -speed / b + timeAlong(pace, distance + speed * speed / (2.0 * b), 0.0);
  }
  const double start = std::min(speed, v);
  const double ramp = (v * v - start * start) / (2.0 * a);
  if (distance >= ramp) return (v - start) / a + (distance - ramp) / v;
  return 2.0 * distance / (start + std::sqrt(start * start + 2.0 * a * distance) + 1e-12);
}

double wayFromRest(const RobotPace& pace, double time) {
  const double ramp = std::min(time, pace.speed / pace.acceleration);
  return pace.acceleration * ramp * ramp / 2.0 + pace.speed * (time - ramp);
}

double farthestIn(const RobotPace& pace, double speed, double time) {
  constexpr double kRounding = 1e-6;  // [m]
  const double start = std::min(speed, pace.speed);
  const double ramp = std::min(time, (pace.speed - start) / pace.acceleration);
  return (start + pace.acceleration * ramp / 2.0) * ramp + pace.speed * (time - ramp) + kRounding;
}

double timeToTurn(const RobotPace& pace, double angle) {
  // Bang-bang turning takes 2 sqrt(angle / a).
  return 2.0 * std::sqrt(angle / pace.turning);
}

double foldedAngle(double sine, double cosine) {
  const double s = std::abs(sine), c = std::abs(cosine);
  const auto arc = [](double tangent) { return tangent * (math::kPi / 4 + 0.273 * (1.0 - tangent)); };
  return s < c ? arc(s / c) : math::kPi / 2 - arc(c / s);
}

Runner::Runner(const RobotState& robot)
    : position(robot.pose.position),
      facing(math::unit(robot.pose.heading)),
      velocity(robot.velocity),
      speed(norm(robot.velocity)) {}

double timeToReach(const RobotPace& pace, const RobotState& robot, Vec2 target) {
  return timeToReach(pace, Runner(robot), target);
}

double timeToReach(const RobotPace& pace, const Runner& robot, Vec2 target) {
  const Vec2 way = target - robot.position;
  const double length = norm(way);
  if (length < 1e-6) return 0.0;
  const Vec2 ahead = way / length;
  const double turn = foldedAngle(cross(robot.facing, ahead), dot(robot.facing, ahead));
  // A robot need not turn fully toward a target that is nearer than about half its body.
  const double needed = turn * std::min(1.0, length / 0.05);
  return kShareOfTurn * timeToTurn(pace, needed) + timeAlong(pace, length, dot(robot.velocity, ahead));
}

double timeToReach(const RobotPace& pace, double distance, double angle) {
  return kShareOfTurn * timeToTurn(pace, angle) + timeAlong(pace, distance, 0.0);
}

}  // namespace fulbito
