#include "strategies/skills/interception.hpp"

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/draws.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

constexpr double kFewTicks = 4.0 / 60.0;  // [s]

RobotState anywhere(Rng& rng) {
  RobotState robot;
  robot.pose = {{rng.uniform(-0.65, 0.65), rng.uniform(-0.55, 0.55)}, rng.uniform(-math::kPi, math::kPi)};
  return robot;
}

BallState anyBall(Rng& rng) {
  BallState ball{{rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)}, {}, {}};
  ball.velocity = test::drawVector(rng, 0.0, 1.2);
  ball.spin = ball.velocity;
  return ball;
}

}  // namespace

TEST_CASE("robot and ball are at the meeting together, and not much earlier", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallCourse course(info.field, info.ball, info.physics);
  const RobotPace pace(info.robot);
  Rng rng(3, test::kTestStream);
  int missed = 0;
  for (int i = 0; i < 1000; ++i) {
    BallPrediction ball;
    ball.predict(course, anyBall(rng), 4.0);
    const RobotState robot = anywhere(rng);
    InterceptionRequest request;
    if (i % 2 == 0) request.aim = Vec2{0.75, 0.0};
    const auto meeting = intercept(ball, pace, robot, request);
    if (!meeting) {
      ++missed;
      continue;
    }
    CHECK(distance(meeting->ball, ball.positionAt(meeting->time)) < 1e-9);
    CHECK(distance(meeting->robot, meeting->ball) == Approx(request.standoff).epsilon(1e-6));
    if (meeting->time > 0.0) CHECK(timeToReach(pace, robot, meeting->robot) < meeting->time + kFewTicks);
    // The search must find any meeting that is earlier by more than a few ticks.
    for (double t = 0.05; t < meeting->time - 0.12; t += 0.05) {
      const Vec2 place = ball.positionAt(t);
      const Vec2 from = request.aim ? *request.aim : place + (place - robot.pose.position);
      const Vec2 there = place - unitOr(from - place, {1.0, 0.0}) * request.standoff;
      CHECK(timeToReach(pace, robot, there) > t - kFewTicks);
    }
  }
  CHECK(missed < 30);
}

}  // namespace fulbito
