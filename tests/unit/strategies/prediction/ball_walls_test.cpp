#include "strategies/prediction/ball_walls.hpp"

#include "engine/core/math/math.hpp"
#include "engine/core/math/random.hpp"
#include "strategies/prediction/ball_prediction.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/draws.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {

TEST_CASE("the time of a fall is the first passage through zero", "[unit]") {
  CHECK(*timeOfFall(1.0, -2.0, 0.0, 1.0) == Approx(0.5));
  CHECK(*timeOfFall(1.0, 1.0, -4.0, 2.0) == Approx(1.0));
  CHECK(*timeOfFall(0.0, -1.0, 0.0, 1.0) == 0.0);
  CHECK(*timeOfFall(-0.001, -1.0, 0.0, 1.0) == 0.0);
  CHECK_FALSE(timeOfFall(1.0, -2.0, 0.0, 0.4));
  CHECK_FALSE(timeOfFall(1.0, -1.0, 1.0, 9.0));  // turns back before
  CHECK_FALSE(timeOfFall(1.0, 1.0, 0.0, 9.0));
}

TEST_CASE("a predicted ball stays on the field, corners and posts included", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallCourse course(info.field, info.ball, info.physics);
  Rng rng(8, Stream::kTest);
  int in_goal = 0;
  for (int i = 0; i < 3000; ++i) {
    BallState ball;
    do {
      ball.position = {rng.uniform(-0.75, 0.75), rng.uniform(-0.65, 0.65)};
    } while (!course.walls.isFree(ball.position));
    ball.velocity = test::drawVector(rng, 0.0, 3.0);
    ball.spin = test::drawVector(rng, 0.0, 2.0);
    BallPrediction prediction;
    prediction.predict(course, ball);
    for (double t = 0.0; t < 3.5; t += 0.05) {
      const Vec2 p = prediction.positionAt(t);
      const bool inside = insideField(info.field, p, info.ball.radius - 0.003);
      // Between the posts the ball is neither on the rectangle nor in the goal by that test.
      const bool between =
          std::abs(p.y) < info.field.goal_width / 2 && std::abs(p.x) < info.field.length / 2 + 0.1;
      if (!inside && !between) {
        CAPTURE(i, t, p.x, p.y);
        FAIL_CHECK("the ball is in a wall");
      }
      in_goal += std::abs(p.x) > info.field.length / 2;
    }
  }
  CHECK(in_goal > 100);
}

TEST_CASE("a ball on a post comes back", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallCourse course(info.field, info.ball, info.physics);
  const Vec2 velocity{1.0, 0.0};
  BallPrediction prediction;
  prediction.predict(course, {{0.4, info.field.goal_width / 2}, velocity, velocity});
  CHECK(prediction.bouncesBefore(2.0) >= 1);
  CHECK(prediction.positionAt(0.4).x < info.field.length / 2 - info.ball.radius + 1e-9);
  CHECK(prediction.velocityAt(0.5).x < 0.0);
}

}  // namespace fulbito
