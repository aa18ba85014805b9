#include "strategies/libero_striker.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math.hpp"

namespace fulbito::libero {
namespace {

constexpr double kRound = 0.105;    // [m] circle on which to come round the ball
constexpr double kSharpness = 2.0;  // n of the field
constexpr double kTouch = 0.075;    // [m] centre to centre where the ball is about touched
constexpr double kSpinTime = 0.45;  // [s]

Twist spin(StrikerMemory& memory, double dt) {
  memory.spin_left -= dt;
  if (memory.spin_left <= 0.0) memory.locked = 0.4;
  return {0.0, memory.spin_sense * 28.0};
}

/// Robot and ball press on something and nothing moves.
void watchJam(const Picture& picture, const RobotState& robot, Vec2 rel, StrikerMemory& memory) {
  const bool slow =
      squaredNorm(picture.ball.now().velocity) < 0.08 * 0.08 && squaredNorm(robot.velocity) < 0.12 * 0.12;
  const bool near = squaredNorm(rel) < kTouch * kTouch;
  memory.jammed = slow && near ? memory.jammed + picture.seen.dt : 0.0;
  memory.locked = std::max(0.0, memory.locked - picture.seen.dt);
}

}  // namespace

Interception interception(const Picture& picture, const RobotState& robot) {
  const Vec2 goal = picture.pitch.theirGoal();
  const auto strikePoint = [&](Vec2 ball) { return ball - unitOr(goal - ball, {1.0, 0.0}) * 0.06; };
  if (picture.ball.resting()) {
    const Vec2 ball = picture.ball.sample(0);
    return {timeToReach(picture.pitch, robot, strikePoint(ball)), ball};
  }
  double late = 0.0;  // by how much the robot came too late at the step before
  for (int i = 0; i <= BallForecast::kSteps; i += 2) {
    const double time = i * BallForecast::kStep;
    const Vec2 ball = picture.ball.sample(i);
    const double least = picture.pitch.speed * time + 0.12;
    if (squaredNorm(ball - robot.pose.position) > least * least && i < BallForecast::kSteps) continue;
    const double needed = timeToReach(picture.pitch, robot, strikePoint(ball));
    if (needed <= time || i == BallForecast::kSteps) {
      if (i == 0) return {needed, ball};
      const double early = time - needed;
      const double at =
          late > 0.0 && early > 0.0 ? time - 2 * BallForecast::kStep * early / (early + late) : time;
      return {std::max(at, needed - 0.1), picture.ball.at(at)};
    }
    late = needed - time;
  }
  return {};
}

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

Twist strike(const Picture& picture, int robot, StrikerMemory& memory) {
  const RobotState& self = picture.own(robot);
  const Pitch& pitch = picture.pitch;
  const Vec2 now = picture.ball.now().position;
  const Vec2 rel = now - self.pose.position;
  watchJam(picture, self, rel, memory);
  if (memory.spin_left > 0.0) return spin(memory, picture.seen.dt);

  const Interception meet = interception(picture, self);
  const bool close = squaredNorm(rel) < 0.10 * 0.10;
  const Vec2 ball = close ? now + picture.ball.now().velocity * 0.03 : meet.ball;
  memory.mouth = openMouth(picture, ball, memory.mouth);
  const Aim aim = aimAt(pitch, ball, {pitch.half_length + 0.02, memory.mouth});

  if (memory.jammed > 0.35 && memory.locked <= 0.0) {
    memory.spin_left = kSpinTime;
    memory.jammed = 0.0;
    memory.spin_sense = cross(rel, aim.direction) >= 0.0 ? 1.0 : -1.0;
    return spin(memory, picture.seen.dt);
  }
  const double direction = math::angleOf(aim.direction);
  const double heading = approachHeading(self.pose.position + self.velocity * 0.04, aim.contact, direction,
                                         kRound, kSharpness, memory.side);
  return alongHeading(pitch, self, heading, pitch.speed);
}

}  // namespace fulbito::libero
