// Teams in processes of their own, in whole matches: they play as in this process, and no misbehaviour stops
// a match.

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <set>
#include <sstream>
#include <string>

#include "fulbito/match.hpp"
#include "fulbito/outside.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/team_memory.hpp"

namespace fulbito {
namespace {

std::int64_t steadyNow() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

TeamCatalogue catalogue(OutsideOptions::Isolation isolation = OutsideOptions::Isolation::kProcess) {
  OutsideOptions options;
  options.isolation = isolation;
  options.clock = steadyNow;
  options.host = FULBITO_TEAM_HOST;
  options.limits.memory = test::kTeamMemory;
  options.limits.processes = 24;
  TeamCatalogue teams = TeamCatalogue::builtIn();
  teams.addSource(outsideTeams(options));
  return teams;
}

MatchConfig configOf(const TeamChoice& blue, const TeamChoice& yellow, double half_seconds) {
  auto config = MatchConfig::standard("idle", "idle");
  REQUIRE(config);
  config->teams = {blue, yellow};
  config->rules.half_seconds = half_seconds;
  return *config;
}

TeamChoice chosen(const std::string& specification,
                  OutsideOptions::Isolation isolation = OutsideOptions::Isolation::kProcess) {
  auto choice = catalogue(isolation).parse(specification);
  INFO((choice ? "" : choice.error().message));
  REQUIRE(choice);
  return *choice;
}

struct Played {
  RefereeState referee;
  MatchFaults faults;
  std::uint64_t hash = 0;
  std::string events;  ///< names of the policy's events and of walk-overs
};

class EventNames : public MatchObserver {
 public:
  void onTick(const MatchTick& tick) override {
    for (const GameEvent& event : tick.events) {
      if (event.law == "policy" || event.clause == "walk-over") names += std::string(event.clause) + " ";
    }
  }
  std::string names;
};

Played play(const MatchConfig& config) {
  auto match = Match::create(config, steadyNow);
  INFO((match ? "" : match.error().message));
  REQUIRE(match);
  EventNames events;
  match->watch(events);
  while (match->step()) {
  }
  return {match->referee(), match->faults(), match->hash(), events.names};
}

std::string misbehaving(const std::string& kind, int at = 3) {
  return "cmd:" FULBITO_MISBEHAVING_TEAM " " + kind + " --at " + std::to_string(at);
}

TEST_CASE("a program plays the match of the built-in team that it is a port of", "[unit]") {
  const auto inside = play(configOf(chosen("chaser"), chosen("chaser"), 2.0));
  const std::string port = "cmd:" FULBITO_CHASER_PROGRAM;
  auto config = configOf(chosen(port), chosen(port), 2.0);
  config.rules.decision_time.decision = 10.0;  // whatever else this machine does
  const auto outside = play(config);
  CHECK(outside.hash == inside.hash);
  for (const TeamFaults& faults : outside.faults.teams) CHECK(faults.rejected() + faults.failures == 0);
}

// Libraries that the loader refuses, or that end their process, are left out: they cannot play here.
const std::vector<std::string> kLibraries = {
    "ported_chaser.so",
    "plain_c.so:gain=0.5,style=calm",
    "printing.so",
    "float_modes.so",
    "broken_kind.so",
    "broken_drawings.so",
    "broken_decision.so",
    "throwing.so:where=begin",
    "throwing.so:where=decide",
    "throwing.so:where=decide,odd=on",
    "throwing.so:where=place",
    "throwing.so:where=stopped",
    "throwing.so:where=ended",
    "ending.so:how=fail,where=decide,at=40",
    "ending.so:how=fail,where=ready",
    "ending.so:how=fail,where=place,at=2",
};

TEST_CASE("a library plays the same match in this process and in its own, whatever its functions return",
          "[unit]") {
  std::set<std::string> failures;
  for (const std::string& library : kLibraries) {
    INFO(library);
    const std::string specification = FULBITO_TEST_LIBRARIES "/" + library;
    std::vector<Played> played;
    for (const auto isolation : {OutsideOptions::Isolation::kProcess, OutsideOptions::Isolation::kNone}) {
      auto config = configOf(chosen(specification, isolation), chosen("chaser"), 1.5);
      config.seed = 11;
      config.rules.decision_time.decision = 10.0;  // whatever else this machine does
      played.push_back(play(config));
    }
    const TeamFaults &apart = played[0].faults.teams[0], &within = played[1].faults.teams[0];
    CHECK(played[0].hash == played[1].hash);
    CHECK(played[0].events == played[1].events);
    CHECK(played[0].referee.score == played[1].referee.score);
    CHECK(played[0].referee.winner == played[1].referee.winner);
    CHECK(apart.failures == within.failures);
    CHECK(apart.failure == within.failure);
    CHECK(apart.forfeited == within.forfeited);
    CHECK(apart.rejected() == within.rejected());
    CHECK(apart.saturated == within.saturated);
    if (within.forfeited) failures.insert(within.failure);
  }
  CHECK(failures.contains("broken: 'decide' fails with 42"));
  CHECK(failures.size() >= 4);
}

// These teams answer correctly, whatever else they try, or their answers do no harm.
const std::set<std::string> kHarmless = {
    "signal-others", "trace-others",      "write-outside",       "read-secrets",       "network",
    "raise-limits",  "gain-rights",       "leave-shared-memory", "meddle-with-others", "unasked-answer",
    "many-answers",  "duplicate-answers", "huge-numbers"};

std::vector<std::string> kindsOfMisbehaviour() {
  std::vector<std::string> kinds;
  const auto close = [](FILE* pipe) { pclose(pipe); };
  const std::unique_ptr<FILE, decltype(close)> list(popen(FULBITO_MISBEHAVING_TEAM " --list", "r"), close);
  REQUIRE(list);
  std::array<char, 256> line{};
  while (std::fgets(line.data(), line.size(), list.get()) != nullptr) {
    std::istringstream words(line.data());
    words >> kinds.emplace_back();
  }
  return kinds;
}

// A failing team fails three times per match.
TEST_CASE("a match goes on to its verdict whatever a team does", "[unit][misbehaviour]") {
  const auto kinds = kindsOfMisbehaviour();
  CHECK(kinds.size() >= 30);
  const char* repetitions = std::getenv("FULBITO_REPETITIONS");
  const std::size_t plays = kinds.size() * static_cast<std::size_t>(repetitions ? std::atoi(repetitions) : 1);
  for (std::size_t i = 0; i < plays; ++i) {
    const std::string& kind = kinds[i % kinds.size()];
    INFO(kind);
    auto config = configOf(chosen("idle"), chosen(misbehaving(kind)), 1.0);
    const bool harmless = kHarmless.contains(kind);
    config.rules.decision_time.decision = harmless ? 10.0 : 0.02;  // whatever else this machine does
    config.rules.decision_time.bank = 0.2;
    config.rules.decision_time.held = 3;
    const auto played = play(config);
    CHECK(played.referee.ended);
    CHECK_FALSE(played.faults.abandoned);  // whatever limits of its own it meets
    const TeamFaults& faults = played.faults.teams[indexOf(TeamId::kYellow)];
    CHECK(played.faults.teams[indexOf(TeamId::kBlue)].rejected() == 0);
    CHECK((faults.failures > 0 || faults.not_finite > 0) == !harmless);
    if (!faults.forfeited) continue;
    CHECK(faults.failures == config.rules.decision_time.failures);
    CHECK_FALSE(faults.failure.empty());
    CHECK(played.referee.winner == TeamId::kBlue);
    CHECK(played.events.find("team.failed") != std::string::npos);
    CHECK(played.events.find("walk-over") != std::string::npos);
  }
}

TEST_CASE("a team that ends starts again while play goes on", "[unit]") {
  auto config = configOf(chosen("idle"), chosen(misbehaving("exit-code", 40)), 2.0);
  config.rules.decision_time.failures = 100;
  const auto played = play(config);
  CHECK(played.referee.ended);
  const TeamFaults& faults = played.faults.teams[indexOf(TeamId::kYellow)];
  CHECK(faults.failures >= 2);
  CHECK(faults.failures <= 7);
  CHECK_FALSE(faults.forfeited);
  CHECK(faults.failure == "exit code 7");
}

TEST_CASE("a hung team costs the match its bank of time and what it is held for, no more", "[unit]") {
  auto config = configOf(chosen("idle"), chosen(misbehaving("sleep", 5)), 1.0);
  config.rules.decision_time = {0.01, 0.3, 5, 10.0, 1};
  const auto played = play(config);
  const TeamFaults& faults = played.faults.teams[indexOf(TeamId::kYellow)];
  CHECK(faults.forfeited);
  CHECK(faults.late == 6);
  CHECK(faults.failure == "silent for 6 decisions");
}

TEST_CASE("a team that does not start is refused with the reason", "[unit]") {
  const auto reason = [](const std::string& specification) {
    const auto choice = catalogue().parse(specification);
    REQUIRE_FALSE(choice);
    CHECK(choice.error().code == ErrorCode::kUsage);
    return choice.error().message;
  };
  CHECK(reason("cmd:false") == "team 'cmd:false': exit code 1");
  CHECK(reason("cmd:sh -c 'kill -9 $$'").find("signal 9") != std::string::npos);
  CHECK(reason("cmd:echo hello").find("cmd:echo hello") != std::string::npos);
  CHECK(reason("./CMakeLists.so").find("there is no file") != std::string::npos);
}

TEST_CASE("standard error of a team reaches the log, by lines", "[unit]") {
  OutsideOptions options;
  options.clock = steadyNow;
  std::string log;
  options.log = [&](const std::string& team, std::string_view line) {
    log += team.substr(0, 4) + std::string(line) + "|";
  };
  TeamCatalogue teams = TeamCatalogue::builtIn();
  teams.addSource(outsideTeams(options));
  CHECK_FALSE(teams.parse("cmd:sh -c 'echo one >&2; echo two >&2; printf three >&2'"));
  CHECK(log == "cmd:one|cmd:two|cmd:three|");
}

}  // namespace
}  // namespace fulbito
