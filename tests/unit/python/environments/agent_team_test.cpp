#include "python/environments/agent_team.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

TeamChoice agents(const std::shared_ptr<AgentSlot>& slot, std::optional<TeamChoice> mates) {
  return agentTeam("agents", slot, std::move(mates), *parseNavigator("straight"));
}

MatchConfig agentMatch(const std::shared_ptr<AgentSlot>& slot, const std::string& mates) {
  MatchConfig config = shortMatch("idle", "idle");
  config.rules.restart.delay = 0.0;
  config.teams[0] = agents(slot, mates.empty() ? std::nullopt : std::optional(*parseTeam(mates)));
  return config;
}

}  // namespace

TEST_CASE("a caller sees a tick, then drives its robots in it", "[unit]") {
  const auto slot = std::make_shared<AgentSlot>();
  slot->drives[1] = true;
  auto match = Match::create(agentMatch(slot, ""));
  REQUIRE(match);
  CHECK(slot->info.team == TeamId::kBlue);
  REQUIRE(match->makeReady() == MatchPhase::kReady);
  REQUIRE(match->advance() == MatchPhase::kPlaying);
  for (int i = 0; i < 30; ++i) {
    REQUIRE(match->advance() == MatchPhase::kDeciding);
    CHECK(slot->seen.tick == i);
    CHECK(slot->seen.own[1].state.pose.position == match->world().robots[1].pose.position);
    slot->commands[1] = RobotCommand::byWheels({-8.0, -8.0});
    slot->commands[0] = RobotCommand::byWheels({-8.0, -8.0});  // not the caller's: it stays where it is
    REQUIRE(match->advance() == MatchPhase::kPlaying);
  }
  CHECK(match->world().robots[1].wheels.left < -7.0);
  CHECK(norm(match->world().robots[0].velocity) < 1e-3);
}

TEST_CASE("a caller's places are driven to by its navigator, beside those of the mates", "[unit]") {
  const auto slot = std::make_shared<AgentSlot>();
  slot->drives[1] = true;
  auto match = Match::create(agentMatch(slot, "classic"));
  REQUIRE(match);
  GoTo place;
  place.position = {-0.5, 0.4};
  place.stop = true;
  slot->commands[1] = RobotCommand::drivingTo(place);
  for (int i = 0; i < 180; ++i) REQUIRE(match->step());
  CHECK(distance(match->world().robots[1].pose.position, place.position) < 0.03);
  CHECK(match->faults().teams[0].rejected() == 0);
}

TEST_CASE("mates without a robot of the caller play as they do alone", "[unit]") {
  const MatchConfig alone = shortMatch("classic", "chaser");
  MatchConfig config = alone;
  config.teams[0] = agents(std::make_shared<AgentSlot>(), *parseTeam("classic"));
  CHECK(hashOf(config) == hashOf(alone));
}

TEST_CASE("mates that cannot be made are refused as such", "[unit]") {
  TeamChoice wrong = *parseTeam("classic");
  wrong.settings.push_back({"navigator", "nobody"});
  MatchConfig config = shortMatch();
  config.teams[0] = agents(std::make_shared<AgentSlot>(), wrong);
  const auto match = Match::create(config);
  REQUIRE_FALSE(match);
  CHECK(match.error().message.find("nobody") != std::string::npos);
}

}  // namespace fulbito
