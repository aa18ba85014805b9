#include "strategies/interception.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

/// Where the robot's centre must be when the ball is at `ball`.
Vec2 placeAt(const InterceptionRequest& request, Vec2 robot, Vec2 ball) {
  const Vec2 from = request.aim ? *request.aim : ball + (ball - robot);
  return ball - unitOr(from - ball, {1.0, 0.0}) * request.standoff;
}

/// Time [s] that the robot lacks at `t`: negative when it is there before the ball.
double lack(const BallPrediction& ball, const RobotPace& pace, const RobotState& robot,
            const InterceptionRequest& request, double t) {
  const Vec2 place = placeAt(request, robot.pose.position, ball.positionAt(t));
  const double free_way = distance(place, robot.pose.position);
  // Nearer than the standoff when there is no side to keep: it touches already.
  if (!request.aim && dot(place - robot.pose.position, ball.positionAt(t) - robot.pose.position) <= 0.0) {
    return request.delay - t;
  }
  return (free_way > 1e-6 ? timeToReach(pace, robot, place) : 0.0) + request.delay - t;
}

}  // namespace

std::optional<Interception> intercept(const BallPrediction& ball, const RobotPace& pace,
                                      const RobotState& robot, const InterceptionRequest& request) {
  constexpr double kLeastStep = 1.0 / 60.0;  // [s]
  constexpr int kMaxSteps = 24;
  const auto meeting = [&](double t) {
    const Vec2 place = ball.positionAt(t);
    return Interception{t, place, placeAt(request, robot.pose.position, place)};
  };
  double t = 0.0, missing = lack(ball, pace, robot, request, 0.0);
  if (missing <= 0.0) return meeting(0.0);
  for (int i = 0; i < kMaxSteps && t < request.horizon; ++i) {
    // A ball that rests is a fixed target.
    if (t >= ball.endOfMotion())
      return t + missing <= request.horizon ? std::optional(meeting(t + missing)) : std::nullopt;
    const double ball_speed = norm(ball.velocityAt(t));
    const double step = std::max(kLeastStep, missing * pace.speed / (pace.speed + ball_speed));
    const double next = std::min(t + step, request.horizon);
    const double still = lack(ball, pace, robot, request, next);
    if (still <= 0.0) return meeting(t + (next - t) * missing / (missing - still));
    t = next, missing = still;
  }
  return std::nullopt;
}

std::optional<FirstAtBall> firstAtBall(const BallPrediction& ball, const RobotPace& pace,
                                       std::span<const ObservedRobot> robots) {
  std::optional<FirstAtBall> first;
  InterceptionRequest request;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!robots[i].present) continue;
    if (first) request.horizon = first->time;
    const auto meeting = intercept(ball, pace, robots[i].state, request);
    if (meeting && (!first || meeting->time < first->time)) first = FirstAtBall{i, meeting->time};
  }
  return first;
}

}  // namespace fulbito
