#include "bridge/lines/line_codec.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/piped_team.hpp"
#include "tests/support/test_teams.hpp"
#include "tests/unit/bridge/lines/port_commands.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// A team in a program, after the handshake.
TeamChoice programTeam(LineCodec& codec, const std::vector<std::string>& command) {
  return TeamChoice::own("program", [&codec, command] {
    auto team = std::make_unique<PipedTeam>(codec, command);
    const TeamWelcome welcome = team->hello({"fulbito test", {}});
    if (welcome.name != "chaser" || welcome.version != "1.0") throw std::runtime_error(welcome.name);
    return team;
  });
}

}  // namespace

TEST_CASE("ports of chaser as programs play the match of the built-in chaser, bit for bit", "[unit]") {
  const auto port = static_cast<std::size_t>(GENERATE(0, 1));
  const TeamId seat = GENERATE(TeamId::kBlue, TeamId::kYellow);
  const std::vector<std::string> command = ports()[port];
  CAPTURE(command.front(), nameOf(seat));
  MatchConfig config = shortMatch("chaser", "chaser", 60.0);
  config.vision[indexOf(seat)].latency_ticks = 2;
  config.vision[indexOf(seat)].position_noise = 0.001;
  const std::uint64_t built_in = hashOf(config);
  LineCodec codec;
  config.teams[indexOf(seat)] = programTeam(codec, command);
  CHECK(hashOf(config) == built_in);
}

}  // namespace fulbito
