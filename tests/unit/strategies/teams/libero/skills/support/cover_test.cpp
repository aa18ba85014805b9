#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// The place from which the support covers the goal, with the keeper at `keeper` and a ball at rest.
std::optional<Vec2> covers(Vec2 keeper, Vec2 ball) {
  const libero::Pitch pitch(test::infoOf(3));
  Observation seen;
  seen.team_size = 3;
  seen.own[0] = test::standingAt({keeper, 1.57});
  seen.own[2] = test::standingAt({{-0.2, 0.0}, 0.0});
  seen.ball.position = ball;
  libero::BallForecast forecast;
  forecast.take(seen.ball, {});
  libero::Picture picture{seen, pitch, forecast};
  picture.keeper = 0;
  libero::Memory memory;
  const auto move = libero::support::cover(picture, 2, memory);
  return move ? move->place : std::nullopt;
}

}  // namespace

TEST_CASE("libero's support covers the goal as soon as the keeper's side is at the post", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    const Vec2 ball{-0.72, 0.45 * side};
    CHECK_FALSE(covers({-0.708, 0.15 * side}, ball));
    const auto place = covers({-0.708, 0.175 * side}, ball);
    REQUIRE(place);
    CHECK(side * place->y > 0.0);
    CHECK(distance(*place, {-0.75, 0.0}) < 0.3);  // a keeper's leash
    CHECK_FALSE(covers({-0.708, 0.175 * side}, {-0.4, 0.45 * side}));
  }
}

}  // namespace fulbito
