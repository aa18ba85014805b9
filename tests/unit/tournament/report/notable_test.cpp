#include "tournament/report/notable.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/samples.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

/// `pairs` drawn fixtures between two entrants.
StateMaker drawn(std::size_t pairs) {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"strong", "weak"}, static_cast<int>(pairs)));
  for (std::size_t i = 0; i < pairs; ++i) maker.add({0, 1, 0, i}, pairOf({0, 0}, {0, 0}));
  return maker;
}

TournamentTable ratedTable(Interval strong, Interval weak) {
  TournamentTable table;
  table.ratings.elo = {strong, weak};
  table.ratings.component = {0, 0};
  return table;
}

std::vector<NotableMatch> notable(const StateMaker& maker, const TournamentTable& table) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < maker.state().results.size(); ++i) all.push_back(i);
  return notableMatches(maker.state(), all, table);
}

}  // namespace

TEST_CASE("an upset needs a lead of 100 Elo and intervals that do not meet", "[unit]") {
  StateMaker maker = drawn(3);
  maker.state().results[1] = pairOf({0, 1}, {0, 0});
  const auto upset = [&](Interval strong, Interval weak) {
    const auto found = notable(maker, ratedTable(strong, weak));
    return !found.empty() && found[0].why.starts_with("upset: ");
  };
  CHECK(upset({210, 150, 270}, {-210, -270, -150}));
  CHECK(upset({50, 10, 90}, {-50, -90, 9}));
  CHECK_FALSE(upset({49, 10, 90}, {-50, -90, 9}));   // 99 Elo
  CHECK_FALSE(upset({50, 10, 90}, {-50, -90, 10}));  // intervals meet
  CHECK_FALSE(upset({-210, -270, -150}, {210, 150, 270}));
  const auto found = notable(maker, ratedTable({210, 150, 270}, {-210, -270, -150}));
  CHECK(found[0].why == "upset: weak (-210) beat strong (+210)");
  CHECK(found[0].fixture == 1);
  CHECK(found[0].leg == 0);
  CHECK(found[0].id == idOfNumber(1, 0));
}

TEST_CASE("teams that never met cannot upset each other", "[unit]") {
  StateMaker maker = drawn(1);
  maker.state().results[0] = pairOf({0, 1}, {0, 0});
  TournamentTable table = ratedTable({210, 150, 270}, {-210, -270, -150});
  table.ratings.component = {0, 1};
  const auto found = notable(maker, table);
  REQUIRE(found.size() == 1);
  CHECK(found[0].why == "strong lost 0:1 to weak from kick-off:0");
}

TEST_CASE("walk-overs come before crashes, upsets and the worst loss of each team", "[unit]") {
  StateMaker maker = drawn(6);
  auto& results = maker.state().results;
  results[0] = pairOf({0, 5}, {0, 0});  // the worst loss of the strong team, and an upset
  results[1] = pairOf({4, 0}, {1, 0});  // the worst loss of the weak team
  results[3]->legs[0].faults.teams[1].failures = 1;
  results[3]->legs[0].faults.teams[1].failure = "exit code 1\nwhile \"deciding\"";
  results[3]->legs[0].outcome = MatchOutcome::kCrash;
  results[4]->legs[1].faults.teams[0].forfeited = true;
  results[4]->legs[1].outcome = MatchOutcome::kForfeit;
  const auto found = notable(maker, ratedTable({210, 150, 270}, {-210, -270, -150}));
  REQUIRE(found.size() == 4);
  CHECK(found[0].why == "weak forfeited");
  CHECK(found[1].why == "weak crashed: exit code 1 while \"deciding\"");
  CHECK(found[2].why == "upset: weak (-210) beat strong (+210)");
  CHECK(found[3].why == "weak lost 0:4 to strong from kick-off:1");
}

TEST_CASE("however much happens, few matches of a kind are notable", "[unit]") {
  const std::size_t teams = 40;
  StateMaker maker = madeUpRoundRobin(teamNames(teams));
  for (auto& pair : maker.state().results) {
    for (MatchResult& leg : pair->legs) {
      leg.outcome = MatchOutcome::kCrash;
      for (TeamFaults& faults : leg.faults.teams) faults.failures = 1;
    }
  }
  const auto found = tableOf(maker.state()).notable;
  CHECK(found.size() == kMostNotable);
  CHECK(std::count_if(found.begin(), found.end(),
                      [](const auto& m) { return m.why.find("crashed") != std::string::npos; }) <= 8);
  CHECK(found.back().why.find(" lost ") != std::string::npos);
}
