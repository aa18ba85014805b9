#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// The place to which the support goes forward, with the ball at rest at `ball` for `stuck` [s].
std::optional<Vec2> forward(const char* robot, Vec2 ball, double stuck) {
  const libero::Pitch pitch(test::infoOf(3, robot));
  Observation seen;
  seen.team_size = 3;
  seen.own[2] = test::standingAt({{-0.3, 0.0}, 0.0});
  seen.ball.position = ball;
  libero::BallForecast forecast;
  forecast.take(seen.ball, {});
  libero::Picture picture{seen, pitch, forecast, stuck};
  libero::Memory memory;
  const auto move = libero::support::goForward(picture, 2, memory);
  return move ? move->place : std::nullopt;
}

}  // namespace

TEST_CASE("libero's support waits for rebounds, or with a run-up for a ball thrown across", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    const Vec2 ball{0.375, 0.4 * side};
    const auto near = forward("vsss", ball, 0.0), back = forward("firasim", ball, 0.0);
    REQUIRE(near);
    REQUIRE(back);
    CHECK(side * near->y < 0.0);
    CHECK(side * back->y < 0.0);
    CHECK(back->x < near->x - 0.1);
    // The run-up takes about as long as a ball thrown at 0.5 m/s takes to the middle.
    const libero::Pitch pitch(test::infoOf(3, "firasim"));
    const double way = norm(*back - Vec2{ball.x + 0.1, 0.0}) - pitch.front;
    CHECK(std::abs(timeAlong(pitch.pace, way, 0.0) - 0.4 / 0.5) < 0.15);
  }
}

TEST_CASE("libero's support goes forward when a ball that is stuck becomes a free ball", "[unit]") {
  const Vec2 ball{0.12, 0.62};
  CHECK_FALSE(forward("firasim", ball, 0.0));
  CHECK(forward("firasim", ball, 3.0));
  CHECK_FALSE(forward("firasim", {-0.12, 0.62}, 3.0));
  CHECK_FALSE(forward("vsss", ball, 3.0));
}

}  // namespace fulbito
