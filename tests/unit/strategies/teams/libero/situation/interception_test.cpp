#include "strategies/teams/libero/situation/interception.hpp"

#include <algorithm>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/draws.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// The interception with an estimate at every step, also where a robot cannot come in time.
libero::Interception estimated(const libero::Picture& picture, const RobotState& robot) {
  using libero::BallForecast;
  double late = 0.0;
  for (int i = 0; i <= BallForecast::kSteps; i += 2) {
    const double time = i * BallForecast::kStep;
    const Vec2 ball = picture.ball.sample(i);
    const double least = picture.pitch.speed * time + picture.pitch.around;
    if (distance(ball, robot.pose.position) > least && i < BallForecast::kSteps) continue;
    const Vec2 goal = picture.pitch.theirGoal();
    const Vec2 place = ball - unitOr(goal - ball, {1.0, 0.0}) * picture.pitch.robot_half;
    const double needed = timeToReach(picture.pitch.pace, robot, place), early = time - needed;
    if (needed > time && i < BallForecast::kSteps) {
      late = -early;
      continue;
    }
    if (i == 0) return {needed, ball};
    const bool between = late > 0.0 && early > 0.0;
    const double at = between ? time - 2 * BallForecast::kStep * early / (early + late) : time;
    return {std::max(at, needed - 2 * BallForecast::kStep), picture.ball.at(at)};
  }
  return {};
}

}  // namespace

TEST_CASE("an interception is as if each step was estimated", "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    const MatchInfo info = test::infoOf(3, robot);
    const libero::Pitch pitch(info);
    const BallCourse course(info.field, info.ball, info.physics);
    Rng rng(2, test::kTestStream);
    for (int run = 0; run < 3000; ++run) {
      Observation seen;
      seen.ball.position = {rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)};
      seen.ball.velocity = seen.ball.spin = test::drawVector(rng, 0.05, 2.0);
      RobotState self;
      self.pose = {{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)}, rng.uniform(-math::kPi, math::kPi)};
      self.velocity = test::drawVector(rng, 0.0, 1.2 * pitch.speed);
      BallPrediction way;
      way.predict(course, seen.ball);
      libero::BallForecast ball;
      ball.take(seen.ball, way);
      const libero::Picture picture{seen, pitch, ball};
      const libero::Interception meet = interception(picture, self), wanted = estimated(picture, self);
      CAPTURE(robot, run);
      REQUIRE(meet.time == wanted.time);
      REQUIRE(meet.ball == wanted.ball);
    }
  }
}

}  // namespace fulbito
