#include "strategies/skills/interception.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

/// Where the robot's centre must be when the ball is at `ball`.
Vec2 placeAt(const InterceptionRequest& request, Vec2 robot, Vec2 ball) {
  const Vec2 from = request.aim ? *request.aim : ball + (ball - robot);
  return ball - unitOr(from - ball, {1.0, 0.0}) * request.standoff;
}

/// Time [s] that the robot lacks at `t`: negative when it is there before the ball.
double lack(const BallPrediction& prediction, const RobotPace& pace, const Runner& robot,
            const InterceptionRequest& request, double t) {
  const Vec2 ball = prediction.positionAt(t);
  const Vec2 place = placeAt(request, robot.position, ball);
  // Nearer than the standoff when there is no side to keep: it touches already.
  const bool touches = !request.aim && dot(place - robot.position, ball - robot.position) <= 0.0;
  return (touches ? 0.0 : timeToReach(pace, robot, place)) - t;
}

/// A time and what is missing then.
struct Guess {
  double time;
  double missing;
};

/// Where `lack` passes zero between a guess before and one after, by halves and secants in turn; where it
/// jumps over zero, just after that.
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
  const Runner runner{robot.pose.position, math::unit(robot.pose.heading), robot.velocity};
  const auto meeting = [&](double t) -> std::optional<Interception> {
    if (t > request.horizon) return std::nullopt;
    const Vec2 place = ball.positionAt(t);
    return Interception{t, place, placeAt(request, robot.pose.position, place)};
  };
  double t = 0.0, missing = lack(ball, pace, runner, request, 0.0);
  double closing = 0.0;  // of the missing time, per second of waiting
  if (missing <= 0.0) return meeting(0.0);
  for (int i = 0; i < kMaxSteps && t < request.horizon; ++i) {
    // A ball that rests is a fixed target.
    if (missing < kCloseEnough || t >= ball.endOfMotion()) return meeting(t + missing);
    // A ball that comes closes the gap faster than it would by waiting, one that runs away slower.
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
