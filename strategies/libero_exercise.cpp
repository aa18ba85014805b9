#include "strategies/libero_exercise.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math.hpp"

namespace fulbito::libero {
namespace {

/// As `turnTo`, but the front has to point there.
Twist turnFrontTo(const Pitch& pitch, const RobotState& robot, double heading) {
  const double error = math::wrapAngle(heading - robot.pose.heading);
  return {0.0, std::copysign(fastestTurn(pitch, std::abs(error)), error)};
}

/// Straight on with the ball before the front: the heading is held and not steered at the ball, which keeps
/// its sideways speed (reference page, 2.4).
Twist push(const RobotState& robot, const Exercise& exercise) {
  const double error = math::wrapAngle(exercise.heading - robot.pose.heading);
  return {exercise.speed, 10.0 * error};
}

}  // namespace

Twist exerciseTwist(const Pitch& pitch, const RobotState& robot, Vec2 ball, const Exercise& exercise,
                    int& side) {
  switch (exercise.kind) {
    case Exercise::Kind::kReachPose:
      return restAt(pitch, robot, exercise.target, exercise.heading, 0.012);
    case Exercise::Kind::kTurn:
      return turnFrontTo(pitch, robot, exercise.heading);
    case Exercise::Kind::kReachBall:
      return driveThrough(pitch, robot, ball, math::unit(exercise.heading), kRound, side);
    case Exercise::Kind::kPush:
      return push(robot, exercise);
    case Exercise::Kind::kPredictBall:
      break;
  }
  return {};
}

}  // namespace fulbito::libero
