#include "tournament/tune/tune_run.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"
#include "tournament/tune/tune_folder.hpp"
#include "tournament/tune/tune_report.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;
using Json = nlohmann::json;

/// A tiny tuning, whose matches are just long enough for goals.
TunePlan planOf(bool opponent = false) {
  const TeamChoice team = *parseTeam("classic:strike_speed=0.4,spin=off");
  TunePlan plan;
  plan.team = *TunedTeam::of(team);
  plan.spsa.parameters = parametersOf(team, plan.team, {}, 0.2, 0.5)->parameters;
  plan.spsa.iterations = 4;
  plan.spsa.seed = 3;
  plan.final_pairs = 2;
  plan.base.format = TournamentFormat::kMatch;
  plan.base.pairs = 2;
  plan.base.seed = 3;
  plan.base.match = shortMatch("chaser", "chaser", 10.0);
  plan.base.entrants = {{"team", team, {}}, {"opponent", opponent ? *parseTeam("chaser") : team, {}}};
  plan.opponent = opponent;
  return plan;
}

TuneOutcome run(const TunePlan& plan, MatchStore& log, int jobs = 2, std::size_t stop_after = 1000000) {
  TuneOptions options;
  options.jobs = jobs;
  options.log = &log;
  std::size_t heard = 0;
  options.progress = [&](const RunProgress&) { return ++heard < stop_after; };
  auto outcome = runTune(plan, TeamCatalogue::builtIn(), options);
  REQUIRE(outcome);
  return std::move(*outcome);
}

PairResult pairWon(bool by_first) {
  PairResult pair;
  pair.legs[0].winner = by_first ? TeamId::kBlue : TeamId::kYellow;
  pair.legs[1].winner = by_first ? TeamId::kYellow : TeamId::kBlue;
  return pair;
}

/// A temporary folder that is removed at the end.
struct Folder {
  std::string path = (std::filesystem::temp_directory_path() / "fulbito-tune-XXXXXX").string();
  Folder() { REQUIRE(::mkdtemp(path.data()) != nullptr); }
  ~Folder() { std::filesystem::remove_all(path); }
};

Result<LogFolder> opened(const std::string& path, const TunePlan& plan) {
  return openTuneFolder(path, plan, *MatchIdentity::create(plan.base));
}

}  // namespace

TEST_CASE("both versions of an iteration meet on starts that no other one has", "[unit]") {
  const TunePlan plan = planOf();
  const TunePoint point = startOf(plan.spsa);
  std::set<std::uint64_t> seeds;
  for (int k = 1; k <= 50; ++k) {
    const auto own = iterationPlan(plan, TeamCatalogue::builtIn(), point, k);
    REQUIRE(own);
    CHECK(own->format == TournamentFormat::kMatch);
    REQUIRE(own->entrants.size() == 2);
    const TunePair versions = versionsAt(plan.spsa, point, k);
    CHECK(own->entrants[0].team.text == plan.team.at(plan.spsa.parameters, versions.plus));
    CHECK(own->entrants[1].team.text == plan.team.at(plan.spsa.parameters, versions.minus));
    for (std::size_t start = 0; start < 2; ++start) seeds.insert(seedOfStart(own->seed, start));
  }
  const auto finals = finalPlans(plan, TeamCatalogue::builtIn(), point);
  REQUIRE(finals);
  REQUIRE(finals->size() == 1);
  for (std::size_t start = 0; start < 2; ++start) seeds.insert(seedOfStart((*finals)[0].plan.seed, start));
  CHECK(seeds.size() == 102);
}

TEST_CASE("kinds of starts go on from one iteration to the next", "[unit]") {
  TunePlan plan = planOf();
  plan.base.book.kinds = {StartKind::kKickOff, StartKind::kFreeBall, StartKind::kPenalty};
  std::vector<StartKind> kinds;
  for (int k = 1; k <= 3; ++k) {
    const auto own = iterationPlan(plan, TeamCatalogue::builtIn(), startOf(plan.spsa), k);
    REQUIRE(own);
    for (std::size_t start = 0; start < 2; ++start) kinds.push_back(bookEntry(own->book, start).kind);
  }
  for (std::size_t i = 0; i < kinds.size(); ++i) CHECK(kinds[i] == plan.base.book.kinds[i % 3]);
}

TEST_CASE("with an opponent both versions meet it on the same starts and see as the team", "[unit]") {
  TunePlan plan = planOf(true);
  plan.base.match.vision[0].latency_ticks = 3;
  plan.base.match.vision[1].latency_ticks = 7;
  const auto own = iterationPlan(plan, TeamCatalogue::builtIn(), startOf(plan.spsa), 1);
  REQUIRE(own);
  const Schedule schedule = scheduleOf(*own, {});
  REQUIRE(schedule.fixtures.size() == 4);
  std::set<std::size_t> starts[3];
  for (const Fixture& fixture : schedule.fixtures) {
    starts[fixture.b].insert(fixture.start);
    const auto match = matchOf(*own, fixture, 0);
    REQUIRE(match);
    CHECK(match->teams[0].text == "chaser");
    CHECK(match->vision[0].latency_ticks == 7);
    CHECK(match->vision[1].latency_ticks == 3);
  }
  CHECK(starts[1] == starts[2]);
  const auto finals = finalPlans(plan, TeamCatalogue::builtIn(), startOf(plan.spsa));
  REQUIRE(finals);
  REQUIRE(finals->size() == 3);
  // The plan of the tuned team against the start team.
  CHECK((*finals)[0].plan.match.vision[1].latency_ticks == 3);
  CHECK((*finals)[2].first == "start");
  CHECK((*finals)[2].plan.match.vision[1].latency_ticks == 7);
}

TEST_CASE("an iteration's result is the lead of the plus version in points", "[unit]") {
  const TunePlan self = planOf();
  const auto own = iterationPlan(self, TeamCatalogue::builtIn(), startOf(self.spsa), 1);
  const Schedule schedule = scheduleOf(*own, {});
  FixtureResults results{pairWon(true), pairWon(true)};
  CHECK(iterationResult(self, schedule, results) == 1.0);
  results[1] = pairWon(false);
  CHECK(iterationResult(self, schedule, results) == 0.0);

  const TunePlan against = planOf(true);
  const auto gauntlet = iterationPlan(against, TeamCatalogue::builtIn(), startOf(against.spsa), 1);
  const Schedule both = scheduleOf(*gauntlet, {});
  FixtureResults meetings;
  // On all starts, the opponent loses to plus and beats minus.
  for (const Fixture& fixture : both.fixtures) meetings.emplace_back(pairWon(fixture.b == 2));
  CHECK(iterationResult(against, both, meetings) == 1.0);
  for (auto& meeting : meetings) meeting = pairWon(true);
  CHECK(iterationResult(against, both, meetings) == 0.0);
}

TEST_CASE("neither jobs nor stops change a tuning", "[unit]") {
  for (const bool opponent : {false, true}) {
    const TunePlan plan = planOf(opponent);
    MatchMemory alone_log, log;
    const TuneOutcome alone = run(plan, alone_log, 1), together = run(plan, log, 3);
    REQUIRE(alone.results.size() == 4);
    REQUIRE_FALSE(alone.finals.empty());
    CHECK(alone.played == matchesOf(plan));
    // With draws only, no point would move, and the test would be meaningless.
    CHECK(pathOf(plan.spsa, alone.results).back() != startOf(plan.spsa));
    CHECK(tuneJson(plan, alone) == tuneJson(plan, together));

    MatchMemory kept;
    TuneOutcome part;
    std::size_t runs = 0;
    do {
      part = run(plan, kept, 1, 5);
      ++runs;
      CHECK(part.interrupted == (part.finals.size() < alone.finals.size()));
    } while (part.interrupted && runs < 30);
    CHECK(runs > 3);
    CHECK(tuneJson(plan, part) == tuneJson(plan, alone));
    CHECK(run(plan, kept).played == 0);
  }
}

TEST_CASE("a folder continues its own tuning only, and says what differs", "[unit]") {
  const Folder folder;
  const TunePlan plan = planOf();
  {
    const auto first = opened(folder.path, plan);
    REQUIRE(first);
    run(plan, *first->log);
  }
  {
    const auto again = opened(folder.path, plan);
    REQUIRE(again);
    CHECK(again->changed.empty());
    CHECK(run(plan, *again->log).played == 0);
  }
  const auto refused = [&](auto change) {
    TunePlan other = plan;
    change(other);
    const auto folder_of_other = opened(folder.path, other);
    return folder_of_other ? std::string() : folder_of_other.error().message;
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  CHECK(contains(refused([](TunePlan& p) { p.spsa.iterations = 5; }), "iterations: 4 -> 5"));
  CHECK(contains(refused([](TunePlan& p) { p.final_pairs = 9; }), "final_pairs: 2 -> 9"));
  CHECK(contains(refused([](TunePlan& p) { p.spsa.parameters[0].step = 1.5; }), "r_end: 0.5 -> 1.5"));
  CHECK(contains(refused([](TunePlan& p) { p.spsa.parameters.pop_back(); }),
                 "parameters.strike_speed.start: 0.4"));
  CHECK(contains(refused([](TunePlan& p) { p.base.pairs = 3; }), "pairs: 2 -> 3"));
  CHECK(contains(refused([](TunePlan& p) { p.base.seed = 4; }), "seed: 3 -> 4"));
  CHECK(contains(refused([](TunePlan& p) { p.opponent = true; }), "against"));
}

TEST_CASE("a folder of something else is refused", "[unit]") {
  const Folder folder;
  std::ofstream(folder.path + "/tune.json") << "{}";
  const auto damaged = opened(folder.path, planOf());
  REQUIRE_FALSE(damaged);
  CHECK(damaged.error().code == ErrorCode::kBadInput);
  std::ofstream(folder.path + "/plan.json") << "{}";
  const auto tournament = opened(folder.path, planOf());
  REQUIRE_FALSE(tournament);
  CHECK(tournament.error().code == ErrorCode::kUsage);
}

TEST_CASE("with an opponent the gain is a difference over the same starts", "[unit]") {
  const TunePlan plan = planOf(true);
  TuneOutcome outcome;
  outcome.results = {0.0, 0.0, 0.0, 0.0};
  CHECK_FALSE(gainOf(outcome));
  // The starts differ more than the teams do, so only the paired difference shows the gain.
  const std::vector<double> start{0.0, 0.25, 0.5, 0.75, 0.0, 0.5, 0.25, 0.75};
  std::vector<double> tuned = start;
  for (std::size_t i = 0; i < tuned.size(); ++i) tuned[i] += i == 2 ? 0.0 : 0.25;
  outcome.finals = {{"tuned", "start", {{1, 1, 1, 1, 1}}, {}},
                    {"tuned", "opponent", {}, tuned},
                    {"start", "opponent", {}, start}};
  const auto gain = gainOf(outcome);
  REQUIRE(gain);
  CHECK(gain->value == Approx(0.25 * 7 / 8));
  CHECK(improvementOf(*gain) == Improvement::kShown);
  CHECK(tuneText(plan, outcome).find("does better than the start") != std::string::npos);
  CHECK(Json::parse(tuneJson(plan, outcome))["gain"]["value"] == gain->value);
  std::swap(outcome.finals[1].points, outcome.finals[2].points);
  CHECK(tuneText(plan, outcome).find("does worse than the start") != std::string::npos);
  outcome.finals[1].points = outcome.finals[2].points;
  CHECK(tuneText(plan, outcome).find("No improvement against the opponent") != std::string::npos);
}

TEST_CASE("reports say what improved, and what did not", "[unit]") {
  const TunePlan plan = planOf();
  TuneOutcome outcome;
  outcome.results = {1.0, -0.5, 0.25, 0.0};
  const auto with = [&](std::array<std::int64_t, kPairScores> counts) {
    outcome.finals = {{"tuned", "start", {counts}, {}}};
    return tuneText(plan, outcome);
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  CHECK(contains(with({2, 3, 10, 30, 55}), "stronger than the start"));
  CHECK(contains(with({20, 20, 20, 20, 20}), "No improvement over the start is shown"));
  CHECK(contains(with({55, 30, 10, 3, 2}), "weaker than the start"));
  outcome.finals = {{"tuned", "start", {{0, 0, 0, 0, 200}}, std::vector<double>(200, 1.0)}};
  const Json test = Json::parse(tuneJson(plan, outcome))["finals"][0]["test"];
  CHECK(test["verdict"] == "pass");
  CHECK(test["pairs"] < 200);
  CHECK(contains(tuneText(plan, outcome), "between +0 and +50 normalized Elo: pass, a verdict after"));
  const std::string tuned = plan.team.at(plan.spsa.parameters, pathOf(plan.spsa, outcome.results).back());
  CHECK(contains(with({1, 1, 1, 1, 1}), tuned));
  TunePlan program = plan;
  program.team = {"cmd:./team.py 'one word'", true, {}};
  CHECK(contains(tuneText(program, outcome), "  'cmd:./team.py '\\''one word'\\'' :"));
  const Json json = Json::parse(tuneJson(plan, outcome));
  CHECK(json["tuned"] == tuned);
  CHECK(json["path"].size() == 5);
  CHECK(json["finals"][0]["improvement"] == "not shown");
  CHECK(json["finals"][0]["pairs"] == 5);
  CHECK(json["parameters"][2]["start"] == 0.4);
  CHECK(json["opponent"].is_null());
  outcome.finals[0].counts.counts = {0, 0, 0, 0, 7};
  CHECK(Json::parse(tuneJson(plan, outcome))["finals"][0]["elo"]["value"].is_null());
  outcome.finals.clear();
  outcome.results.pop_back();
  CHECK(contains(tuneText(plan, outcome), "3 of 4 iterations"));
}

}  // namespace fulbito
