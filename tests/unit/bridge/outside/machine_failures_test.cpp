// Failures of the machine are no fault of a team: the match has no result, whatever system call fails.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include "engine/core/system/machine_room.hpp"
#include "fulbito/match.hpp"
#include "fulbito/outside.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/failing_calls.hpp"
#include "tests/support/team_memory.hpp"

namespace fulbito {
namespace {

std::int64_t steadyNow() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// A team outside the program against one inside, with enough time for a busy machine.
MatchConfig outsideMatch() {
  OutsideOptions options;
  options.clock = steadyNow;
  options.limits.memory = test::kTeamMemory;
  TeamCatalogue teams = TeamCatalogue::builtIn();
  teams.addSource(outsideTeams(options));
  auto config = MatchConfig::standard("idle", "random");
  REQUIRE(config);
  const auto program = teams.parse("cmd:" FULBITO_CHASER_PROGRAM);
  INFO((program ? "" : program.error().message));
  REQUIRE(program);
  config->teams[0] = *program;
  config->decision_time = DecisionTime{20.0, 100.0, 100, 60.0, 3};
  return *config;
}

enum Outcome { kWhole, kNotPlayed, kOtherError, kAbandoned, kTeamsFault };

Outcome outcomeOf(const Result<Match>& match) {
  if (!match) return match.error().code == ErrorCode::kMachine ? kNotPlayed : kOtherError;
  const MatchFaults faults = match->faults();
  if (faults.abandoned) return faults.abandoned->code == ErrorCode::kMachine ? kNotPlayed : kAbandoned;
  return faults.teams[0].failures > 0 || faults.teams[0].forfeited ? kTeamsFault : kWhole;
}

Outcome play(const MatchConfig& config, Tick ticks) {
  try {
    auto match = Match::create(config, steadyNow);
    while (match && match->tick() < ticks && match->step()) {
    }
    if (match) match->finish();
    return outcomeOf(match);
  } catch (const std::exception&) {
    return machineError().code == ErrorCode::kMachine ? kNotPlayed : kOtherError;
  }
}

std::vector<pid_t> childrenOfThis() {
  std::ifstream list("/proc/self/task/" + std::to_string(::getpid()) + "/children");
  std::vector<pid_t> children;
  for (pid_t child = 0; list >> child;) children.push_back(child);
  return children;
}

}  // namespace

#ifndef FULBITO_SANITIZED  // whose allocators end the program where there is no memory
TEST_CASE("whatever call of a start or a tick fails, the match is whole or not played", "[unit][calls]") {
  const MatchConfig config = outsideMatch();
  const auto task = [&] { return static_cast<int>(play(config, 3)); };
  const bool all = std::getenv("FULBITO_EVERY_CALL") != nullptr;
  const int step = all ? 1 : 13, variants = all ? 4 : 1;
  int whole = 0, not_played = 0;
  bool more = true;
  for (int call = 0; more; call += step) {
    for (int variant = 0; variant < variants; ++variant) {
      const auto result = test::withFailingCall(task, "chaser_program", call, variant + (all ? 0 : call));
      more = !result.call.empty();
      INFO("call " << call << ": " << result.call << ", outcome " << result.code);
      CHECK((result.code == kWhole || result.code == kNotPlayed));
      ++(result.code == kWhole ? whole : not_played);
    }
  }
  CHECK(whole > 0);
  CHECK(not_played > 0);
}
#endif

TEST_CASE("a match ends without a result when somebody kills a team's keeper", "[unit]") {
  const MatchConfig config = outsideMatch();
  auto match = Match::create(config, steadyNow);
  REQUIRE(match);
  while (match->tick() < 5) REQUIRE(match->step());
  const std::vector<pid_t> keepers = childrenOfThis();
  REQUIRE(keepers.size() == 1);
  ::kill(keepers.front(), SIGKILL);
  while (match->step()) {
  }
  CHECK(outcomeOf(match) == kNotPlayed);
  CHECK_THAT(match->faults().abandoned->message,
             Catch::StartsWith("blue team: ") && Catch::Contains("keeper"));
  CHECK(match->faults().teams[0].failures == 0);
  CHECK_FALSE(match->referee().ended);
}

}  // namespace fulbito
