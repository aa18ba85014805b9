#include "match/match.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

MatchConfig chasers() {
  MatchConfig config;
  config.teams = {*parseTeam("chaser"), *parseTeam("chaser")};
  config.robot = *loadRobot("vsss");
  config.physics = *loadPhysics("standard");
  config.field = *loadField("vsss-3v3");
  config.rules.half_seconds = 5.0;
  return config;
}

}  // namespace

TEST_CASE("the same configuration gives the same match", "[unit]") {
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    auto match = Match::create(chasers());
    REQUIRE(match);
    while (match->step()) {
    }
    CHECK(match->referee().ended);
    hash = match->hash();
  }
  CHECK(hashes[0] == hashes[1]);
}

}  // namespace fulbito
