#include "strategies/skills/interception.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

/// Where the robot's centre must be when the ball is at `ball`.
Vec2 placeAt(const InterceptionRequest& request, Vec2 robot, Vec2 ball) {
  const Vec2 from = request.aim ? *request.aim : ball + (ball - robot);
  return ball - unitOr(from - ball, {1.0, 0.0}) * request.standoff;
}

/// How late [s] the robot is when it meets the ball at time `t`; negative if it is early.
double lack(const BallPrediction& prediction, const RobotPace& pace, const Runner& robot,
            const InterceptionRequest& request, double t) {
  const Vec2 ball = prediction.positionAt(t);
  const Vec2 place = placeAt(request, robot.position, ball);
  // Without an aim, a robot nearer than the standoff already touches the ball.
  const bool touches = !request.aim && dot(place - robot.position, ball - robot.position) <= 0.0;
  return (touches ? 0.0 : timeToReach(pace, robot, place)) - t;
}

/// A meeting time and how late the robot is then, both in s.
struct Guess {
  double time;
  double missing;
};

/// The time between `before` and `after` at which `lack` crosses zero, by bisection and secant steps in turn.
/// If `lack` jumps over zero, the result is just after the jump.
template <typename Lack>
double narrowed(const Lack& lack, Guess before, Guess after) {
  constexpr double kCloseEnough = 0.01;  // [s]
  constexpr int kMaxSteps = 8;
  for (int i = 0; i < kMaxSteps && after.time - before.time > kCloseEnough && after.missing < -kCloseEnough;
       ++i) {
    const double share = i % 2 == 0 ? before.missing / (before.missing - after.missing) : 0.5;
    const double time = before.time + share * (after.time - before.time);
    const double missing = lack(time);
    (missing > 0.0 ? before : after) = {time, missing};
  }
  return after.time;
}

}  // namespace

std::optional<Interception> intercept(const BallPrediction& ball, const RobotPace& pace,
                                      const RobotState& robot, const InterceptionRequest& request) {
  constexpr double kLeastStep = 1.0 / 60.0, kCloseEnough = 0.01;  // [s]
  constexpr int kMaxSteps = 24;
  const Runner runner(robot);
  const auto meeting = [&](double t) -> std::optional<Interception> {
    if (t > request.horizon) return std::nullopt;
    const Vec2 place = ball.positionAt(t);
    return Interception{t, place, placeAt(request, robot.pose.position, place)};
  };
  double t = 0.0, missing = lack(ball, pace, runner, request, 0.0);
  double closing = 0.0;  // change of `missing` per second of waiting, as a reduction
  if (missing <= 0.0) return meeting(0.0);
  for (int i = 0; i < kMaxSteps && t < request.horizon; ++i) {
    // A ball that rests is a fixed target.
    if (missing < kCloseEnough || t >= ball.endOfMotion()) return meeting(t + missing);
    // The missing time falls faster than the time that passes if the ball approaches, and slower if it
    // recedes.
    const double step = std::max(kLeastStep, closing > 0.0 ? missing / closing : 0.5 * missing);
    const double next = std::min(t + step, request.horizon);
    const double still = lack(ball, pace, runner, request, next);
    if (still <= 0.0) {
      return meeting(narrowed([&](double when) { return lack(ball, pace, runner, request, when); },
                              {t, missing}, {next, still}));
    }
    closing = (missing - still) / (next - t);
    t = next, missing = still;
  }
  return std::nullopt;
}

}  // namespace fulbito
