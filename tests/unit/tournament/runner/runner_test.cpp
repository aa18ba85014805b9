#include "tournament/runner/runner.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>

#include "fulbito/statistics.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"
#include "tournament/runner/play_match.hpp"
#include "tournament/store/match_store.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

TournamentPlan planWith(std::vector<TeamChoice> teams, int pairs, double half_seconds,
                        TournamentFormat format = TournamentFormat::kMatch) {
  TournamentPlan plan;
  plan.format = format;
  plan.match = shortMatch("chaser", "chaser", half_seconds);
  plan.pairs = pairs;
  for (TeamChoice& team : teams) {
    plan.entrants.push_back({"team " + std::to_string(plan.entrants.size() + 1), std::move(team), {}});
  }
  return plan;
}

TournamentPlan planOf(const std::vector<std::string>& teams, int pairs, double half_seconds,
                      TournamentFormat format = TournamentFormat::kMatch) {
  std::vector<TeamChoice> choices;
  for (const std::string& team : teams) choices.push_back(*parseTeam(team));
  return planWith(std::move(choices), pairs, half_seconds, format);
}

/// Identities made from names, because the teams of tests have no sources.
MatchIdentity identityOf(const TournamentPlan& plan) {
  std::vector<TeamIdentity> teams;
  for (const Entrant& entrant : plan.entrants) {
    TeamIdentity team;
    team.hash = entrant.team.text + entrant.name;
    teams.push_back(team);
  }
  return *MatchIdentity::restore(plan, "engine", "00000000000000000000000000000001", teams);
}

Result<RunOutcome> run(const TournamentPlan& plan, MatchStore& log, int jobs = 2, Shard shard = {}) {
  RunnerOptions options;
  options.jobs = jobs;
  options.log = &log;
  options.shard = shard;
  return runTournament(plan, identityOf(plan), options);
}

Result<RunOutcome> run(const TournamentPlan& plan, int jobs = 2) {
  MatchMemory memory;
  return run(plan, memory, jobs);
}

std::vector<std::uint64_t> hashesOf(const TournamentState& state) {
  std::vector<std::uint64_t> hashes;
  for (std::size_t i = 0; i < state.counted; ++i) {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      hashes.push_back(state.results[i] ? state.results[i]->legs[leg].hash : 0);
    }
  }
  return hashes;
}

}  // namespace

TEST_CASE("a team against itself cancels in every pair, from every kind of start", "[unit]") {
  TournamentPlan plan = planOf({"chaser", "chaser"}, 10, 10.0);
  plan.book.kinds = {StartKind::kKickOff, StartKind::kFreeBall, StartKind::kPenalty, StartKind::kGoalKick,
                     StartKind::kPlay};
  for (VisionModel& seat : plan.match.vision) seat.position_noise = 0.002;
  const auto played = run(plan);
  REQUIRE(played);
  REQUIRE(played->state.finished());
  std::set<std::uint64_t> hashes;
  for (const auto& pair : played->state.results) {
    REQUIRE(pair);
    CHECK(pair->legs[0].hash == pair->legs[1].hash);
    CHECK(pair->points() == 0.5);
    CHECK(pair->goalsOfA() == pair->goalsOfB());
    hashes.insert(pair->legs[0].hash);
  }
  CHECK(hashes.size() == 10);
}

TEST_CASE("the number of jobs changes no result", "[unit]") {
  for (const TournamentFormat format :
       {TournamentFormat::kRoundRobin, TournamentFormat::kKnockOut, TournamentFormat::kSwiss,
        TournamentFormat::kLadder, TournamentFormat::kGauntlet}) {
    const TournamentPlan plan = planOf({"chaser", "random", "idle", "classic"}, 1, 3.0, format);
    const auto alone = run(plan, 1), together = run(plan, 4);
    REQUIRE(alone);
    REQUIRE(together);
    CHECK(alone->state.finished());
    CHECK(hashesOf(alone->state) == hashesOf(together->state));
  }
}

TEST_CASE("shards play each match once, and together all", "[unit]") {
  const TournamentPlan plan = planOf({"chaser", "random", "idle"}, 2, 3.0, TournamentFormat::kRoundRobin);
  const auto whole = run(plan);
  REQUIRE(whole);
  MatchMemory memory;
  std::size_t played = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    MatchMemory own;
    const auto part = run(plan, own, 2, {i, 3});
    REQUIRE(part);
    CHECK_FALSE(part->state.finished());
    played += part->played;
    REQUIRE(run(plan, memory, 2, {i, 3}));
  }
  CHECK(played == 12);
  const TournamentState merged = stateOf(plan, identityOf(plan), memory);
  CHECK(merged.finished());
  CHECK(hashesOf(merged) == hashesOf(whole->state));
}

TEST_CASE("the second leg exchanges the seats: points and goals follow the team", "[unit]") {
  const TestEntry still([](const Observation&) { return allWheels({}); });
  const TournamentPlan plan = planWith({*parseTeam("chaser"), still.choice()}, 2, 150.0);
  const auto played = run(plan);
  REQUIRE(played);
  double points = 0.0;
  for (const auto& pair : played->state.results) {
    const PerTeam<int>&first = pair->legs[0].score, &second = pair->legs[1].score;
    CHECK(first[0] >= first[1]);  // a team that stands still scores only by mistakes of the other
    CHECK(second[1] >= second[0]);
    CHECK(pair->goalsOfA() == first[0] + second[1]);
    CHECK(pair->goalsOfB() == first[1] + second[0]);
    points += pair->points();
  }
  CHECK(points > 1.0);
  // The result equals that of playing the match alone.
  const auto config = matchOf(plan, played->state.schedule.fixtures[0], 0);
  REQUIRE(config);
  auto match = Match::create(*config);
  REQUIRE(match);
  StatisticsObserver watcher;
  match->watch(watcher);
  while (match->step()) {
  }
  const MatchResult& first = played->state.results[0]->legs[0];
  CHECK(first.hash == match->hash());
  CHECK(first.ticks == match->tick());
  CHECK(first.play.play_ticks == watcher.statistics().play_ticks);
  CHECK(first.play.wall_ticks == watcher.statistics().wall_ticks);
  for (const TeamId team : kTeams) {
    CHECK(first.play.teams[indexOf(team)].shots == watcher.statistics().teams[indexOf(team)].shots);
    CHECK(first.goals_after_foul[indexOf(team)] ==
          watcher.statistics().teams[indexOf(team)].goals_after_foul);
  }
}

TEST_CASE("how a team sees goes with it from seat to seat", "[unit]") {
  std::atomic<int> poor{0}, good{0}, wrong{0};
  const auto looking = [](std::atomic<int>& right, std::atomic<int>& odd, bool late) {
    return TestEntry([&right, &odd, late](const Observation& seen) {
      if (seen.tick == (late ? -9 : 0)) ++right;
      if (seen.tick < (late ? -9 : 0)) ++odd;
      return allWheels({});
    });
  };
  const TestEntry first = looking(poor, wrong, true), second = looking(good, wrong, false);
  TournamentPlan plan = planWith({first.choice(), second.choice()}, 2, 2.0);
  plan.match.vision[0].latency_ticks = 9;
  REQUIRE(run(plan));
  CHECK(poor == 4);
  CHECK(good == 4);
  CHECK(wrong == 0);
}

TEST_CASE("a run that is stopped keeps what it has, and the next one plays only the rest", "[unit]") {
  const TournamentPlan plan = planOf({"chaser", "chaser"}, 10, 2.0);
  const auto whole = run(plan);
  REQUIRE(whole);
  MatchMemory memory;
  RunnerOptions options;
  options.jobs = 2;
  options.log = &memory;
  options.progress = [](const RunProgress& progress) {
    CHECK(progress.known == 20);
    return progress.done < 9;
  };
  const auto part = runTournament(plan, identityOf(plan), options);
  REQUIRE(part);
  CHECK(part->interrupted);
  CHECK(part->played >= 9);
  CHECK(part->played <= 11);
  CHECK_FALSE(part->state.finished());
  const auto rest = run(plan, memory);
  REQUIRE(rest);
  CHECK(rest->taken == part->played);
  CHECK(rest->played + rest->taken == 20);
  CHECK(hashesOf(rest->state) == hashesOf(whole->state));
}

TEST_CASE("a test ends the tournament at the same pair, whatever the jobs", "[unit]") {
  TournamentPlan plan = planOf({"chaser", "idle"}, 200, 15.0);
  plan.sprt = SprtBounds{};
  const auto alone = run(plan, 1), together = run(plan, 5);
  REQUIRE(alone);
  REQUIRE(together);
  CHECK(alone->state.finished());
  CHECK(alone->state.sprt->verdict() == SprtVerdict::kPass);
  CHECK(alone->state.counted < 100);
  CHECK(alone->state.counted == together->state.counted);
  CHECK(hashesOf(alone->state) == hashesOf(together->state));
  CHECK(static_cast<std::size_t>(alone->state.sprt->counts().pairs()) == alone->state.counted);
}

TEST_CASE("matches of the log that do not repeat are found and told apart from those that do", "[unit]") {
  std::atomic<int> started{0};
  TestEntry moody([&started](const Observation& seen) {
    if (seen.tick == 0) ++started;
    return allWheels({started > 4 ? 10.0 : 5.0, 5.0});
  });
  const TournamentPlan plan = planWith({moody.choice(), *parseTeam("idle")}, 2, 2.0);
  MatchMemory memory;
  REQUIRE(run(plan, memory, 1));
  RunnerOptions options;
  options.jobs = 1;
  options.log = &memory;
  options.verify = 1.0;
  const auto again = runTournament(plan, identityOf(plan), options);
  REQUIRE(again);
  CHECK(again->played == 0);
  CHECK(again->verified == 4);
  CHECK(again->mismatches.size() == 4);
  const TournamentPlan calm = planOf({"chaser", "idle"}, 2, 2.0);
  MatchMemory other;
  options.log = &other;
  const auto same = runTournament(calm, identityOf(calm), options);
  REQUIRE(same);
  CHECK(same->verified == 4);
  CHECK(same->mismatches.empty());
}

TEST_CASE("what the machine fails is played again and never counted", "[unit]") {
  const TournamentPlan plan = planOf({"chaser", "idle"}, 2, 2.0);
  const auto full = [] { return fail(ErrorCode::kIo, "no space left"); };
  std::mutex mutex;
  std::set<MatchId> seen;
  // A recorder fails the attempt because the machine lacks room, either before or after the match.
  const auto watchFailing = [&](bool before, bool always) {
    return [&, before, always](const MatchConfig&, const MatchId& id) -> Result<MatchWatch> {
      const std::lock_guard lock(mutex);
      const bool fails = seen.insert(id).second || always;
      if (fails && before) return full();
      return MatchWatch{std::make_shared<StatisticsObserver>(),
                        [&, fails]() -> Result<void> { return fails ? full() : Result<void>(); }};
    };
  };
  for (const bool before : {true, false}) {
    INFO(before);
    seen.clear();
    MatchMemory memory;
    RunnerOptions options;
    options.jobs = 2;
    options.log = &memory;
    options.watch = watchFailing(before, false);
    const auto played = runTournament(plan, identityOf(plan), options);
    REQUIRE(played);
    CHECK(played->state.finished());
    CHECK(played->played == 4);
    CHECK(played->retried == 4);
    MatchMemory none;
    options.log = &none;
    options.watch = watchFailing(before, true);
    const auto failed = runTournament(plan, identityOf(plan), options);
    REQUIRE_FALSE(failed);
    CHECK(failed.error().message == "no space left");
    CHECK_FALSE(none.find(identityOf(plan).of({0, 1, 0, 0}, 0)));
  }
}

/// A machine with room for `room` teams at once. Its teams stand still.
struct SmallMachine {
  int room = 0;
  std::atomic<int> running{0};
  std::atomic<int> cuts{0};  ///< number of teams that fail at their third decision

  TeamChoice team() {
    return TeamChoice::own("small", [this] { return std::make_unique<Team>(*this); });
  }

  class Team final : public Strategy {
   public:
    explicit Team(SmallMachine& machine) : machine_(machine) {
      if (++machine.running > machine.room) cut("no process is left");
    }
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    ~Team() override { --machine_.running; }
    void begin(const MatchInfo&) override {}
    TeamCommand decide(const Observation&) override {
      if (++decisions_ == 3 && machine_.cuts-- > 0) cut("its keeper ended");
      return {};
    }
    const TeamCondition& condition() const override { return condition_; }

   private:
    void cut(const char* reason) {
      condition_.state = TeamCondition::State::kCut;
      condition_.reason = reason;
    }
    SmallMachine& machine_;
    TeamCondition condition_;
    int decisions_ = 0;
  };
};

TEST_CASE("matches that the machine has no room for wait, and count no fault", "[unit]") {
  SmallMachine machine;
  machine.room = 2;  // room for one match
  const TournamentPlan plan = planWith({machine.team(), machine.team()}, 6, 2.0);
  MatchMemory memory;
  const auto played = run(plan, memory, 8);
  REQUIRE(played);
  CHECK(played->state.finished());
  CHECK(played->state.unplayed.empty());
  CHECK(played->played == 12);
  CHECK(failedMatches(played->state) == 0);
}

TEST_CASE("a match that the machine cuts is played again, whole", "[unit]") {
  SmallMachine machine;
  machine.room = 100;
  machine.cuts = 3;
  const TournamentPlan plan = planWith({machine.team(), machine.team()}, 4, 2.0);
  MatchMemory memory;
  const auto played = run(plan, memory, 1);
  REQUIRE(played);
  CHECK(played->state.finished());
  CHECK(played->retried > 0);
  CHECK(failedMatches(played->state) == 0);
}

TEST_CASE("a match that the machine always fails is named and not kept; the same run plays it later",
          "[unit]") {
  SmallMachine machine;
  machine.room = 1;  // room for one of the two teams of a match
  TournamentPlan plan =
      planWith({machine.team(), *parseTeam("idle"), machine.team()}, 1, 2.0, TournamentFormat::kRoundRobin);
  MatchMemory memory;
  const auto first = run(plan, memory, 1);
  REQUIRE(first);
  CHECK_FALSE(first->state.finished());
  CHECK(first->played == 4);
  REQUIRE(first->state.unplayed.size() == 2);
  CHECK_THAT(first->state.unplayed[0].reason, Catch::Contains("no process is left"));
  for (const UnplayedMatch& match : first->state.unplayed) {
    CHECK_FALSE(memory.find(first->state.ids[match.fixture][match.leg]));
  }
  machine.room = 2;
  const auto second = run(plan, memory, 1);
  REQUIRE(second);
  CHECK(second->state.finished());
  CHECK(second->state.unplayed.empty());
  CHECK(second->played == 2);
}

TEST_CASE("a test ends without a verdict at a match that the machine fails", "[unit]") {
  SmallMachine machine;
  TournamentPlan plan = planWith({machine.team(), *parseTeam("idle")}, 400, 2.0);
  plan.sprt = SprtBounds{0.0, 50.0, 0.05, 0.05};
  MatchMemory memory;
  const auto ended = run(plan, memory, 1);
  REQUIRE(ended);
  CHECK(ended->played == 0);
  CHECK(ended->state.unplayed.size() == 1);
  CHECK_FALSE(ended->state.finished());
}

TEST_CASE("each match is watched once, and a match that is only compared is not", "[unit]") {
  const TournamentPlan plan = planOf({"chaser", "idle"}, 2, 2.0);
  MatchMemory memory;
  std::mutex mutex;
  std::vector<std::string> begun, ended;
  RunnerOptions options;
  options.jobs = 2;
  options.log = &memory;
  options.verify = 1.0;
  options.watch = [&](const MatchConfig&, const MatchId& id) -> Result<MatchWatch> {
    const std::lock_guard lock(mutex);
    begun.push_back(id.text());
    return MatchWatch{std::make_shared<StatisticsObserver>(), [&, text = id.text()]() -> Result<void> {
                        const std::lock_guard at_end(mutex);
                        ended.push_back(text);
                        return {};
                      }};
  };
  const auto played = runTournament(plan, identityOf(plan), options);
  REQUIRE(played);
  CHECK(played->verified == 4);
  std::sort(begun.begin(), begun.end());
  std::sort(ended.begin(), ended.end());
  CHECK(begun.size() == 4);
  CHECK(std::adjacent_find(begun.begin(), begun.end()) == begun.end());
  CHECK(begun == ended);
}

TEST_CASE("outcomes by the worst fault", "[unit]") {
  MatchFaults faults;
  CHECK(outcomeOf(faults, false, false) == MatchOutcome::kNormal);
  CHECK(outcomeOf(faults, false, true) == MatchOutcome::kMercy);
  faults.teams[1].late = 3;
  CHECK(outcomeOf(faults, false, true) == MatchOutcome::kSlow);
  faults.teams[0].not_finite = 1;
  CHECK(outcomeOf(faults, false, false) == MatchOutcome::kIllegal);
  faults.teams[0].failures = 1;
  CHECK(outcomeOf(faults, false, false) == MatchOutcome::kCrash);
  faults.teams[0].forfeited = true;
  CHECK(outcomeOf(faults, false, false) == MatchOutcome::kForfeit);
  CHECK(outcomeOf({}, true, false) == MatchOutcome::kForfeit);
}

TEST_CASE("the lead that the rules name is told apart from a match played out", "[unit]") {
  const TestEntry still([](const Observation&) { return allWheels({}); });
  TournamentPlan plan = planWith({*parseTeam("chaser"), still.choice()}, 1, 300.0);
  plan.match.rules.periods.mercy_goals = 1;
  const auto played = run(plan);
  REQUIRE(played);
  CHECK(played->state.results[0]->legs[0].outcome == MatchOutcome::kMercy);
}

TEST_CASE("turns let only so many work at a time, and everyone in the end", "[unit]") {
  Turns turns(2);
  std::atomic<int> working{0}, most{0}, done{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 50; ++round) {
        const Turn turn(turns);
        const int now = ++working;
        int before = most;
        while (before < now && !most.compare_exchange_weak(before, now)) {
        }
        std::this_thread::yield();
        --working;
        ++done;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(done == 400);
  CHECK(most <= 2);
}

TEST_CASE("seeds of starts: the first is the tournament's own, none twice", "[unit]") {
  CHECK(seedOfStart(77, 0) == 77);
  std::set<std::uint64_t> seeds;
  for (std::size_t i = 0; i < 10000; ++i) seeds.insert(seedOfStart(1, i));
  CHECK(seeds.size() == 10000);
  CHECK(seedOfStart(1, 1) != seedOfStart(2, 1));
}

TEST_CASE("what a tournament cannot play is refused", "[unit]") {
  TournamentPlan plan = planOf({"chaser", "chaser"}, 0, 1.0);
  CHECK(run(plan).error().message.find("pairs") != std::string::npos);
  plan.pairs = 1;
  CHECK(run(plan, -1).error().message == "jobs: -1 is outside 0 ... 1024");
  plan.match.vision[1].dropout = 2.0;
  CHECK(run(plan).error().message == "dropout: 2 is outside 0 ... 0.99");
  plan = planOf({"chaser", "idle"}, 1, 1.0);
  for (const auto& [bounds, name] : {std::pair{SprtBounds{10.0, -10.0, 0.05, 0.05}, "bounds: "},
                                     std::pair{SprtBounds{0.0, 5000.0, 0.05, 0.05}, "bounds: "},
                                     std::pair{SprtBounds{0.0, 10.0, 0.0, 0.05}, "alpha: "},
                                     std::pair{SprtBounds{0.0, 10.0, 0.05, 0.6}, "beta: "}}) {
    plan.sprt = bounds;
    CHECK(run(plan).error().message.find(name) == 0);
  }
}

}  // namespace fulbito
