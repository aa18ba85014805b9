#include "strategies/teams/libero/situation/interception.hpp"

#include <algorithm>

#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito::libero {
namespace {

/// The place [m] from which a robot strikes a ball.
Vec2 strikePoint(const Pitch& pitch, Vec2 ball) {
  return ball - unitOr(pitch.theirGoal() - ball, {1.0, 0.0}) * pitch.robot_half;
}

/// A robot that chases a rolling ball.
struct Chase {
  const Picture& picture;
  Runner runner;

  static double time(int i) { return i * BallForecast::kStep; }
  /// Time [s] that the robot needs to the ball of step `i`.
  double needed(int i) const {
    return timeToReach(picture.pitch.pace, runner, strikePoint(picture.pitch, picture.ball.sample(i)));
  }

  /// Whether the ball of step `i` is within `way` [m].
  bool isWithin(double way, int i) const {
    return squaredNorm(picture.ball.sample(i) - runner.position) <= way * way;
  }
  /// Whether the robot is so late there that it does not matter by how much.
  bool isFar(int i) const { return !isWithin(picture.pitch.speed * time(i) + picture.pitch.around, i); }
  /// Whether the robot is late there at any heading, which takes less time to tell than by how much.
  bool isLate(int i) const {
    return !isWithin(farthestIn(picture.pitch.pace, runner.speed, time(i)) + picture.pitch.robot_half, i);
  }
};

}  // namespace

Interception interception(const Picture& picture, const RobotState& robot) {
  if (picture.ball.resting()) {
    const Vec2 ball = picture.ball.sample(0);
    return {timeToReach(picture.pitch.pace, robot, strikePoint(picture.pitch, ball)), ball};
  }
  const Chase chase{picture, Runner(robot)};
  double late = 0.0;  // [s] by which the robot is too late at the previous step
  int unknown = -1;   // that step, if it is not known yet by how much; else -1
  for (int i = 0; i <= BallForecast::kSteps; i += 2) {
    const bool last = i == BallForecast::kSteps;
    if (!last && chase.isFar(i)) continue;
    if (!last && chase.isLate(i)) {
      unknown = i;
      continue;
    }
    const double time = Chase::time(i), needed = chase.needed(i);
    if (needed <= time || last) {
      if (i == 0) return {needed, picture.ball.sample(i)};
      if (unknown >= 0) late = chase.needed(unknown) - Chase::time(unknown);
      const double early = time - needed;
      const double at =
          late > 0.0 && early > 0.0 ? time - 2 * BallForecast::kStep * early / (early + late) : time;
      return {std::max(at, needed - 2 * BallForecast::kStep), picture.ball.at(at)};
    }
    late = needed - time;
    unknown = -1;
  }
  return {};
}

}  // namespace fulbito::libero
