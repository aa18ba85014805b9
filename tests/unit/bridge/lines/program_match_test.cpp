#include <fstream>

#include "bridge/lines/line_codec.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/piped_team.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_teams.hpp"
#include "tests/unit/bridge/lines/port_commands.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// A team in a program, after the handshake.
TeamChoice programTeam(LineCodec& codec, const std::vector<std::string>& command, const std::string& name) {
  return TeamChoice::own("program", [&codec, command, name] {
    auto team = std::make_unique<PipedTeam>(codec, command);
    const TeamWelcome welcome = team->hello({"fulbito test", {}});
    if (welcome.name != name) throw std::runtime_error(welcome.name);
    return team;
  });
}

/// The Python program that docs/team-protocol.md shows.
std::string shownProgram() {
  std::ifstream in(FULBITO_SOURCE_DIR "/docs/team-protocol.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const std::string mark = "```python\n";
  const std::size_t from = page.find(mark) + mark.size();
  return page.substr(from, page.find("```", from) - from);
}

/// Goals of blue and yellow in a match.
PerTeam<int> scoreOf(const MatchConfig& config) {
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->step()) {
  }
  return match->referee().score;
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
  config.teams[indexOf(seat)] = programTeam(codec, command, "chaser");
  CHECK(hashOf(config) == built_in);
}

TEST_CASE("the program that the page of the protocol shows beats idle", "[unit]") {
  const ScratchFolder folder;
  LineCodec codec;
  const std::string program = folder.write("small.py", shownProgram());
  // It drives at the ball from any side, and so scores own goals, too: one match says little.
  PerTeam<int> goals{};
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    MatchConfig config = shortMatch("idle", "idle", 60.0);
    config.seed = seed;
    config.teams[0] = programTeam(codec, {FULBITO_PYTHON, program}, "small");
    const PerTeam<int> score = scoreOf(config);
    goals[0] += score[0], goals[1] += score[1];
  }
  CHECK(goals[0] > goals[1]);
}

TEST_CASE("the example team of navigators and roles beats idle as a program", "[unit]") {
  LineCodec codec;
  MatchConfig config = shortMatch("idle", "idle", 60.0);
  config.teams[1] = programTeam(codec, pythonTeam("trio.py"), "trio");
  const PerTeam<int> score = scoreOf(config);
  CHECK(score[1] > score[0]);
}

}  // namespace fulbito
