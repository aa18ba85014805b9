#include "strategies/teams/libero/defence/goal_line.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/driven.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero's keeper knows where a ball crosses its line", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  const BallCourse course(info.field, info.ball, info.physics);
  const double line = -pitch.half_length + 0.05;
  Rng rng(1, test::kTestStream);
  int crossings = 0;
  for (int run = 0; run < 600; ++run) {
    Observation seen;
    seen.ball.position = {rng.uniform(-0.6, 0.5), rng.uniform(-0.4, 0.4)};
    seen.ball.velocity = math::unit(rng.uniform(-math::kPi, math::kPi)) * rng.uniform(0.3, 1.5);
    seen.ball.spin = seen.ball.velocity;
    BallPrediction way;
    way.predict(course, seen.ball);
    libero::BallForecast ball;
    ball.take(seen.ball, way);
    const auto found = libero::crossing({seen, pitch, ball}, line);
    const auto exact = way.crossing({line, 0.0}, {-1.0, 0.0});
    CAPTURE(run);
    // Beside the goal, a ball may cross the line and return between two steps of the forecast.
    const bool enters = exact && exact->time < 1.15 && std::abs(exact->place.y) < pitch.goal_half - 0.03;
    if (enters) {
      REQUIRE(found);
      // A bounce between two steps of the forecast shortens the path.
      CHECK(*found == Approx(exact->place.y).margin(0.03));
      ++crossings;
    } else if (!exact) {
      CHECK_FALSE(found);
    }
  }
  CHECK(crossings > 20);
}

TEST_CASE("libero's keeper slides along its line and stops where it should", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  const libero::BallForecast ball;
  const double line = -pitch.half_length + 0.042;
  Observation seen;
  seen.ball.position = {0.5, 0.0};
  const libero::Picture picture{seen, pitch, ball};
  Rng rng(2, test::kTestStream);
  for (int run = 0; run < 100; ++run) {
    RobotState keeper;
    const double side = run % 2 == 0 ? 1.0 : -1.0;
    keeper.pose = {{line, rng.uniform(-0.17, 0.17)}, side * math::kPi / 2};
    const double y = rng.uniform(-0.17, 0.17);
    const bool up = y > keeper.pose.position.y;
    double farthest = 0.0, past = 0.0;
    for (int tick = 0; tick < 90; ++tick) {
      keeper = test::driven(info, keeper, libero::slideTo(picture, keeper, line, y));
      farthest = std::max(farthest, std::abs(keeper.pose.position.x - line));
      past = std::max(past, (keeper.pose.position.y - y) * (up ? 1.0 : -1.0));
    }
    CAPTURE(run);
    CHECK(farthest < 0.01);
    CHECK(past < 0.01);
    CHECK(keeper.pose.position.y == Approx(y).margin(0.005));
  }
}

}  // namespace fulbito
