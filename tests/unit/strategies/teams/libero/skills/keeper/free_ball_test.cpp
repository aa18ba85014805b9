#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("a keeper that is placed at a free ball disputes it, and one in its goal leaves it to mates",
          "[unit]") {
  const libero::Pitch pitch(test::infoOf(3, "firasim"));
  const auto disputes = [&](Vec2 keeper, RestartKind restart) {
    Observation seen;
    seen.team_size = 3;
    seen.own[0] = test::standingAt({keeper, 0.0});
    seen.own[1] = test::standingAt({{-0.6, 0.55}, 0.0});
    seen.opponents[0] = test::standingAt({{-0.175, 0.4}, math::kPi});
    seen.ball.position = {-0.375, 0.4};
    seen.restart = restart;
    seen.since_restart = 0.2;
    libero::BallForecast ball;
    ball.take(seen.ball, {});
    libero::Picture picture{seen, pitch, ball};
    picture.keeper = 0;
    libero::Memory memory;
    const auto move = libero::keeper::freeBall(picture, 0, memory);
    if (move) CHECK(move->twist.linear == pitch.speed);
    return move.has_value();
  };
  CHECK(disputes({-0.575, 0.4}, RestartKind::kFreeBall));
  CHECK_FALSE(disputes({-0.71, 0.1}, RestartKind::kFreeBall));
  CHECK_FALSE(disputes({-0.575, 0.4}, RestartKind::kGoalKick));
}

}  // namespace fulbito
