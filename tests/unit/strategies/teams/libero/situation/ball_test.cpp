#include "strategies/teams/libero/situation/ball.hpp"

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/draws.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero's forecast is the prediction, in even steps and held at its end", "[unit]") {
  using libero::BallForecast;
  const MatchInfo info = test::infoOf(3);
  const BallCourse course(info.field, info.ball, info.physics);
  Rng rng(4, test::kTestStream);
  for (int run = 0; run < 200; ++run) {
    BallState ball{{rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)}, {}, {}};
    ball.velocity = ball.spin = test::drawVector(rng, 0.1, 1.5);
    BallPrediction way;
    way.predict(course, ball);
    BallForecast forecast;
    forecast.take(ball, way);
    CHECK_FALSE(forecast.resting());
    for (int i = 0; i <= BallForecast::kSteps; ++i) {
      const double time = i * BallForecast::kStep;
      CHECK(distance(forecast.sample(i), way.positionAt(time)) < 1e-9);
      CHECK(distance(forecast.at(time), forecast.sample(i)) < 1e-6);
      // A time between two steps gives a place between theirs.
      const Vec2 next = forecast.sample(std::min(i + 1, BallForecast::kSteps));
      const Vec2 half = forecast.at(time + BallForecast::kStep / 2);
      CHECK(distance(half, (forecast.sample(i) + next) / 2) < 1e-6);
    }
    CHECK(distance(forecast.at(99.0), forecast.sample(BallForecast::kSteps)) < 1e-6);
    // A prediction that ends at the forecast's horizon gives the same to the last bit.
    BallPrediction short_way;
    short_way.predict(course, ball, BallForecast::horizon());
    BallForecast same;
    same.take(ball, short_way);
    for (int i = 0; i <= BallForecast::kSteps; ++i) CHECK(same.sample(i) == forecast.sample(i));
  }
  BallForecast still;
  still.take({{0.1, 0.2}, {}, {}}, {});
  CHECK(still.resting());
  CHECK(still.at(1.0) == Vec2{0.1, 0.2});
}

}  // namespace fulbito
