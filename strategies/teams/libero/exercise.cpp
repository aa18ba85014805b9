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
Twist push(const Pitch& pitch, const RobotState& robot, const Exercise& exercise) {
  const double error = math::wrapAngle(exercise.heading - robot.pose.heading);
  return {exercise.speed, pitch.tuning.push_gain * error};
}

/// Waits behind the ball until the robot is aligned, then drives at it: slower than in play, and more
/// reliable. It takes a run-up that is long enough for the asked speed.
Twist runUp(const Pitch& pitch, const RobotState& robot, Vec2 ball, const Exercise& exercise,
            ExerciseMemory& memory) {
  const double along = exercise.heading;
  const Vec2 direction = math::unit(along);
  const Vec2 local = intoFrame(direction, robot.pose.position - ball);
  const double skew = std::abs(foldedError(along, robot.pose.heading));
  const double exact = pitch.tuning.clearance, behind = pitch.touch + pitch.ball_radius;
  if (local.x < -behind && std::abs(local.y) < exact && skew < pitch.tuning.slant / 2) memory.runs_up = true;
  if (memory.runs_up) {
    const double aside = std::clamp(local.y / pitch.around, -pitch.tuning.slant, pitch.tuning.slant);
    return alongHeading(pitch, robot, along - aside, pitch.speed);
  }
  if (local.x > -roundRadius(pitch, ball.x)) {
    const double heading =
        approachHeading(pitch, robot.pose.position, ball, along, pitch.touch + pitch.front, memory.side);
    return alongHeading(pitch, robot, heading, pitch.speed);
  }
  const double run = exercise.speed * exercise.speed / (2 * pitch.plannedSpeedingUp());
  const double way = pitch.front + std::max(pitch.bodies, run);
  return restAt(pitch, robot, ball - direction * way, along, exact);
}

}  // namespace

Twist exerciseTwist(const Pitch& pitch, const RobotState& robot, Vec2 ball, const Exercise& exercise,
                    ExerciseMemory& memory) {
  switch (exercise.kind) {
    case Exercise::Kind::kReachPose:
      return restAt(pitch, robot, exercise.target, exercise.heading, pitch.tuning.clearance);
    case Exercise::Kind::kTurn:
      return turnFrontTo(pitch, robot, exercise.heading);
    case Exercise::Kind::kReachBall:
      return runUp(pitch, robot, ball, exercise, memory);
    case Exercise::Kind::kPush:
      return push(pitch, robot, exercise);
    case Exercise::Kind::kPredictBall:
      break;
  }
  return {};
}

}  // namespace fulbito::libero
