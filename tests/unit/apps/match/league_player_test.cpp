#include "apps/match/league_player.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito::app {
namespace {

wire::Vision frameOf(std::uint32_t step, double ball_x) {
  wire::Vision vision;
  vision.step = step;
  vision.ball.position.x = ball_x;
  vision.robots[0] = {{0, {{{-0.5, 0.0}, 0.0}, {}, 0.0, {}}}};
  return vision;
}

}  // namespace

TEST_CASE("commands that act later make a team think ahead from the newest frame", "[unit]") {
  const int latency = GENERATE(0, 1, 3);
  CAPTURE(latency);
  std::vector<Observation> seen;
  const test::TestEntry team([&](const Observation& observation) {
    seen.push_back(observation);
    return test::allWheels({1.0, 1.0});
  });
  MatchConfig config = test::shortMatch();
  config.teams[0] = team.choice();
  config.vision[0].latency_ticks = latency;
  auto player = LeaguePlayer::create(config, TeamId::kBlue, [] { return std::int64_t{0}; });
  REQUIRE(player);
  player->take({wire::Foul::kKickOff, TeamId::kBlue, 0, 0.0, wire::Half::kFirst});
  REQUIRE(player->play(frameOf(16, 0.0)));
  player->take({wire::Foul::kGameOn, std::nullopt, 0, 0.0, wire::Half::kFirst});
  for (std::uint32_t i = 1; i <= 5; ++i) {
    const auto packet = player->play(frameOf(16 + 16 * i, 0.01 * i));
    REQUIRE(packet);
    CHECK(packet->commands.at(0).wheels.left == 1.0);
  }
  REQUIRE(seen.size() == 5);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    CHECK(seen[i].ball.position.x == Approx(0.01 * static_cast<double>(i + 1)));
    CHECK(seen[i].since_restart == Approx(seen[0].since_restart + static_cast<double>(i) * seen[i].dt));
    if (i > 0) CHECK(seen[i].tick == seen[i - 1].tick + 1);
  }
  // The referee's clock is that of the tick in which the commands act.
  CHECK(seen[0].since_restart == Approx((latency + 1) * seen[0].dt));
}

}  // namespace fulbito::app
