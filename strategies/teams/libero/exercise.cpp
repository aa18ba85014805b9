#include "strategies/teams/libero/exercise.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito::libero {
namespace {

/// As `turnTo`, but with the front, not either end.
Twist turnFrontTo(const Pitch& pitch, const RobotState& robot, double heading) {
  const double error = math::wrapAngle(heading - robot.pose.heading);
  return {0.0, std::copysign(fastestTurn(pitch, std::abs(error)), error)};
}

/// Drives straight with the ball at the front. It holds the heading instead of steering at the ball, so that
/// the ball's sideways speed stays (docs/skills.md, Pushing).
Twist push(const RobotState& robot, const Exercise& exercise) {
  const double error = math::wrapAngle(exercise.heading - robot.pose.heading);
  return {exercise.speed, 10.0 * error};
}

/// Waits behind the ball until the robot is aligned, then drives at it: slower than in play, and more
/// reliable.
Twist runUp(const Pitch& pitch, const RobotState& robot, Vec2 ball, double along, ExerciseMemory& memory) {
  const Vec2 direction = math::unit(along);
  const Vec2 local = intoFrame(direction, robot.pose.position - ball);
  const double skew = std::abs(foldedError(along, robot.pose.heading));
  if (local.x < -0.10 && std::abs(local.y) < 0.006 && skew < 0.08) memory.runs_up = true;
  if (memory.runs_up) {
    return alongHeading(robot, along - std::clamp(6.0 * local.y, -0.2, 0.2), pitch.speed);
  }
  if (local.x > -0.09) {
    const double heading = approachHeading(robot.pose.position, ball, along, 0.13, 3.0, memory.side);
    return alongHeading(robot, heading, pitch.speed);
  }
  return restAt(pitch, robot, ball - direction * 0.16, along, 0.008);
}

}  // namespace

Twist exerciseTwist(const Pitch& pitch, const RobotState& robot, Vec2 ball, const Exercise& exercise,
                    ExerciseMemory& memory) {
  switch (exercise.kind) {
    case Exercise::Kind::kReachPose:
      return restAt(pitch, robot, exercise.target, exercise.heading, 0.012);
    case Exercise::Kind::kTurn:
      return turnFrontTo(pitch, robot, exercise.heading);
    case Exercise::Kind::kReachBall:
      return runUp(pitch, robot, ball, exercise.heading, memory);
    case Exercise::Kind::kPush:
      return push(robot, exercise);
    case Exercise::Kind::kPredictBall:
      break;
  }
  return {};
}

}  // namespace fulbito::libero
