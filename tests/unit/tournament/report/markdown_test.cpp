#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/report.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

std::string markdownOf(const TournamentState& state) { return tournamentMarkdown(state, tableOf(state)); }

}  // namespace

TEST_CASE("the Markdown of a tournament has its tables", "[unit]") {
  StateMaker maker = madeUpRoundRobin({"alpha", "be|ta", "<b>"}, 2);
  maker.state().plan.book.kinds = {StartKind::kKickOff, StartKind::kPenalty};
  const std::string text = markdownOf(maker.state());
  INFO(text);
  CHECK(text.starts_with(
      "<!-- Fulbito -->\n\n## cup\\: round-robin of 3 teams, finished\n\nvsss-3v3, halves of 30 s, "));
  CHECK(text.find("### Standings\n\n| \\# | team | matches |") != std::string::npos);
  CHECK(text.find("### Cross-table") != std::string::npos);
  CHECK(text.find("### Points share \\[%\\] by kind of start") != std::string::npos);
  CHECK(text.find("| be\\|ta |") != std::string::npos);
  CHECK(text.find("<b") == std::string::npos);
}

TEST_CASE("the Markdown of two teams begins with their series", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"alpha", "beta"}));
  maker.add({0, 1, 0, 0}, pairOf({1, 0}, {1, 0}));
  const std::string text = markdownOf(maker.state());
  CHECK(text.find("### alpha against beta\\: 1 swapped pair, 2 matches\n") != std::string::npos);
  CHECK(text.find("| goals | 2 \\: 0 |") != std::string::npos);
}

TEST_CASE("the Markdown of any tournament is below 1 MiB", "[unit]") {
  constexpr std::size_t kTeams = 4000;
  StateMaker maker(planOf(TournamentFormat::kSwiss, {}));
  TournamentState& state = maker.state();
  for (std::size_t i = 0; i < kTeams; ++i) {
    state.plan.entrants.push_back({std::string(1000, '*') + std::to_string(i), *parseTeam("idle"), {}});
  }
  TournamentTable table;
  table.cross.assign(kTeams, std::vector<MeetingSummary>(0));
  table.starts.assign(kTeams, std::vector<MeetingSummary>(kStartKinds));
  table.totals.resize(kTeams);
  table.faults.resize(kTeams);
  table.ratings.elo.resize(kTeams);
  for (std::size_t i = 0; i < kTeams; ++i) {
    table.cross[i].resize(40);
    table.faults[i].outcomes.fill(3);
    table.faults[i].last_failure = std::string(2000, '|');
    table.standings.emplace_back().entrant = i;
    table.bracket.push_back({0, false, i, i, i, std::string(500, '_'), 0.0, 0.0, 0, 0});
  }
  state.plan.book.kinds = {StartKind::kKickOff, StartKind::kPlay};
  const std::string text = tournamentMarkdown(state, table);
  CHECK(text.size() < 1024 * 1024);
  CHECK(text.size() > 256 * 1024);
  CHECK(text.find(" more rows do not fit here.") != std::string::npos);
  state.plan.groups = static_cast<int>(kTeams);
  for (std::size_t i = 0; i < kTeams; ++i) table.standings[i].group = static_cast<int>(i);
  const std::string groups = tournamentMarkdown(state, table);
  CHECK(groups.size() < 1024 * 1024);
  CHECK(groups.find(" more groups do not fit here.") != std::string::npos);
}
