#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/report.hpp"
#include "tournament/store/match_store.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

/// All reports of a tournament, joined.
std::string reportsOf(const TournamentState& state) {
  const TournamentTable table = tableOf(state);
  return tournamentText(state, table) + tournamentJson(state, table) + tournamentCsv(state) +
         tournamentMarkdown(state, table) + tournamentJunit(state, table) +
         tournamentAnnotations(state, table) + tournamentHtml(state, table);
}

}  // namespace

TEST_CASE("the order in which matches end changes no byte of a report", "[unit]") {
  const StateMaker maker = madeUpRoundRobin(teamNames(6), 3);
  const TournamentState& whole = maker.state();
  const std::string expected = reportsOf(whole);
  // The state from a log in another order: the same results by fixture, filled in from the end.
  TournamentState late = whole;
  late.results.assign(whole.results.size(), std::nullopt);
  CHECK(reportsOf(late) != expected);
  for (std::size_t i = whole.results.size(); i-- > 0;) late.results[i] = whole.results[i];
  CHECK(reportsOf(late) == expected);
}

TEST_CASE("one result more or less changes each report", "[unit]") {
  StateMaker maker = madeUpRoundRobin(teamNames(4), 2);
  const std::string all = reportsOf(maker.state());
  maker.state().results[3].reset();
  CHECK(reportsOf(maker.state()) != all);
}
