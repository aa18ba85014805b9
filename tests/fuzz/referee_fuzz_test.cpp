#include <cmath>

#include <fmt/format.h>

#include "fulbito/models.hpp"
#include "tests/fuzz/random_match.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/repetitions.hpp"

/// A million ticks of random robots under the referee.
namespace fulbito::test {
namespace {

const Tick kTicks = Tick{50'000} * repetitions();  // each of eight runs

struct Totals {
  Tick ticks = 0, longest_stuck = 0;
  int matches = 0, restarts = 0, repairs = 0;
  PerTeam<int> goals{};
  std::map<std::string, int> calls;
  std::map<std::string, PerTeam<int>> awarded;

  void add(const RandomMatchResult& r) {
    ++matches, ticks += r.ticks, restarts += r.restarts, repairs += r.repairs;
    longest_stuck = std::max(longest_stuck, r.longest_stuck);
    for (int i = 0; i < 2; ++i) goals[i] += r.goals[i];
    for (const auto& [clause, count] : r.calls) calls[clause] += count;
    for (const auto& [kind, by_side] : r.awarded) {
      for (int i = 0; i < 2; ++i) awarded[kind][i] += by_side[i];
    }
  }

  void print(const std::string& name) const {
    fmt::print("{}: {} ticks, {} matches, {} restarts, {} repairs, longest stuck {} ticks, goals {}:{}\n ",
               name, ticks, matches, restarts, repairs, longest_stuck, goals[0], goals[1]);
    for (const auto& [clause, count] : calls) fmt::print(" {} {}", clause, count);
    fmt::print("\n");
  }
};

RandomMatch matchOf(const std::string& profile) {
  RandomMatch match;
  match.setup.rules = loadRules(profile).value();
  match.setup.field = loadField(match.setup.rules.field).value();
  match.setup.robot = loadRobot("vsss").value().robot;
  match.setup.ball = loadRobot("vsss").value().ball;
  match.physics = loadPhysics("standard").value();
  match.setup.dt = match.physics.controlPeriod();
  return match;
}

/// Matches with other seeds until there are enough ticks.
Totals playLong(RandomMatch match, std::uint64_t first_seed) {
  Totals totals;
  for (std::uint64_t seed = first_seed; totals.ticks < kTicks; ++seed) {
    match.setup.seed = seed;
    match.ticks = kTicks;
    const RandomMatchResult result = playRandomMatch(match);
    INFO("seed " << seed);
    REQUIRE(result.fault == "");
    totals.add(result);
  }
  return totals;
}

/// By how many standard deviations two counts of equal chance differ.
double bias(int a, int b) {
  return a + b == 0 ? 0.0 : std::abs(a - b) / std::sqrt(static_cast<double>(a + b));
}

}  // namespace

TEST_CASE("random 3v3 by the book keeps its promises, and favours no side", "[long][repeated]") {
  Totals all;
  for (const double eager : {0.9, 0.6}) {
    RandomMatch match = matchOf("vsss-3v3");
    match.eager = eager;
    match.setup.rules.stuck.seconds = match.setup.rules.stuck.area_seconds = 4.0;
    const Totals totals = playLong(match, 1);
    totals.print(fmt::format("vsss-3v3, eager {}", eager));
    all.ticks += totals.ticks;
    for (int i = 0; i < 2; ++i) all.goals[i] += totals.goals[i];
    for (const auto& [kind, by_side] : totals.awarded) {
      for (int i = 0; i < 2; ++i) all.awarded[kind][i] += by_side[i];
    }
  }
  CHECK(all.goals[0] + all.goals[1] > 20);
  CHECK(bias(all.goals[0], all.goals[1]) < 4.0);
  for (const char* kind : {"free-ball", "penalty", "goal-kick"}) {
    CAPTURE(kind, all.awarded[kind][0], all.awarded[kind][1]);
    CHECK(bias(all.awarded[kind][0], all.awarded[kind][1]) < 4.0);
  }
}

TEST_CASE("random 3v3 with idle robots: every stuck ball is called", "[long][repeated]") {
  RandomMatch match = matchOf("vsss-3v3");
  match.eager = 0.1, match.idle = 0.9;
  match.proposals = true;
  playLong(match, 100).print("vsss-3v3, idle");
}

TEST_CASE("random 3v3 by the league's program", "[long][repeated]") {
  RandomMatch match = matchOf("league-program-2021");
  match.eager = 0.8;
  playLong(match, 200).print("league-program-2021");
}

TEST_CASE("random training matches with proposals, good and bad", "[long][repeated]") {
  RandomMatch match = matchOf("training");
  match.proposals = true;
  match.eager = 0.8;
  playLong(match, 300).print("training");
}

TEST_CASE("random 5v5 by the book", "[long][repeated]") {
  RandomMatch match = matchOf("vsss-5v5");
  match.eager = 0.8;
  match.proposals = true;
  playLong(match, 400).print("vsss-5v5");
}

TEST_CASE("random short matches through overtime, shoot-out and mercy, with all fouls called",
          "[long][repeated]") {
  RandomMatch match = matchOf("vsss-3v3");
  Rules& rules = match.setup.rules;
  rules.half_seconds = 20.0;
  rules.periods.tie_break = TieBreak::kBoth;
  rules.periods.overtime_seconds = 10.0;
  rules.periods.mercy_goals = 3;
  rules.periods.swap_sides = true;
  rules.fouls.push = true;
  rules.fouls.holding = true;
  match.eager = 0.8;
  playLong(match, 500).print("short");
}

TEST_CASE("random robots that start too early", "[long][repeated]") {
  RandomMatch match = matchOf("vsss-3v3");
  Rules& rules = match.setup.rules;
  rules.half_seconds = 60.0;
  rules.restart.delay = 0.5;
  rules.restart.hold_robots = false;
  match.eager = 0.5, match.idle = 0.3;
  match.proposals = true;
  playLong(match, 600).print("false starts");
}

}  // namespace fulbito::test
