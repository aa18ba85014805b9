#include "strategies/teams/libero/situation/interception.hpp"

#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito::libero {

Interception interception(const Picture& picture, const RobotState& robot) {
  const Vec2 goal = picture.pitch.theirGoal();
  const auto strike_point = [&](Vec2 ball) {
    return ball - unitOr(goal - ball, {1.0, 0.0}) * picture.pitch.robot_half;
  };
  if (picture.ball.resting()) {
    const Vec2 ball = picture.ball.sample(0);
    return {timeToReach(picture.pitch.pace, robot, strike_point(ball)), ball};
  }
  const Runner runner{robot.pose.position, math::unit(robot.pose.heading), robot.velocity};
  double late = 0.0;  // [s] by which the robot is too late at the previous step
  for (int i = 0; i <= BallForecast::kSteps; i += 2) {
    const double time = i * BallForecast::kStep;
    const Vec2 ball = picture.ball.sample(i);
    const double least = picture.pitch.speed * time + picture.pitch.around;
    if (squaredNorm(ball - robot.pose.position) > least * least && i < BallForecast::kSteps) continue;
    const double needed = timeToReach(picture.pitch.pace, runner, strike_point(ball));
    if (needed <= time || i == BallForecast::kSteps) {
      if (i == 0) return {needed, ball};
      const double early = time - needed;
      const double at =
          late > 0.0 && early > 0.0 ? time - 2 * BallForecast::kStep * early / (early + late) : time;
      return {std::max(at, needed - 2 * BallForecast::kStep), picture.ball.at(at)};
    }
    late = needed - time;
  }
  return {};
}

}  // namespace fulbito::libero
