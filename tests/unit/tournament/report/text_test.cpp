#include <sstream>

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/report.hpp"
#include "tournament/report/sections.hpp"
#include "tournament/report/shown_text.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

std::string textOf(const TournamentState& state) { return tournamentText(state, tableOf(state)); }

void checkWidth(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(columnsOf(line) <= 100);
  }
}

}  // namespace

TEST_CASE("a round robin in text", "[unit]") {
  const std::string text = textOf(madeUpRoundRobin({"alpha", "beta", "gamma"}, 4).state());
  INFO(text);
  CHECK(
      text.starts_with("cup: round-robin of 3 teams, finished\n"
                       "  vsss-3v3, halves of 30 s, standard physics, seed 1\n"
                       "  12 of 12 pairs, 24 matches\n"));
  CHECK(text.find("\nStandings\n  #  team   matches  won  drawn  lost  goals  +/-  points  share") !=
        std::string::npos);
  CHECK(text.find("\nCross-table: points share [%] of the row's team\n  #  team") != std::string::npos);
  CHECK(text.find("Points share [%] by kind of start") == std::string::npos);
  CHECK(text.find("Matches to look at\n") != std::string::npos);
  checkWidth(text);
}

TEST_CASE("a tournament that is not finished says how far it is", "[unit]") {
  StateMaker maker = madeUpRoundRobin({"alpha", "beta", "gamma"});
  maker.state().results[1].reset();
  maker.state().schedule.complete = false;
  CHECK(textOf(maker.state())
            .starts_with("cup: round-robin of 3 teams, so far\n"
                         "  vsss-3v3, halves of 30 s, standard physics, seed 1\n"
                         "  2 of 3 pairs known so far, 4 matches\n"));
}

TEST_CASE("no line of a text is wider than 100 columns", "[unit]") {
  StateMaker maker = madeUpRoundRobin(teamNames(12), 5);
  maker.state().plan.book.kinds = {StartKind::kKickOff, StartKind::kFreeBall, StartKind::kPenalty,
                                   StartKind::kGoalKick, StartKind::kPlay};
  auto& entrants = maker.state().plan.entrants;
  entrants[0].name = std::string(10000, 'x');
  entrants[1].name = "球球球球球球球球球球球球球球球球球球球球球球球球";
  entrants[2].name =
      "\xe2\x80\xae"
      "evil\x1b[31m\n" +
      std::string(200, '\t');
  for (auto& pair : maker.state().results) {
    pair->legs[0].outcome = MatchOutcome::kCrash;
    pair->legs[0].faults.teams[1].failures = 1;
    pair->legs[0].faults.teams[1].failure = std::string(5000, 'y') + "\n\x1b]0;title\x07";
  }
  const std::string text = textOf(maker.state());
  INFO(text);
  checkWidth(text);
  CHECK(text.find('\x1b') == std::string::npos);
  CHECK(text.find("kick-off  ") != std::string::npos);
  CHECK(text.find("Matches with faults\n") != std::string::npos);
}

TEST_CASE("a cross-table of many teams is no text", "[unit]") {
  CHECK(textOf(madeUpRoundRobin(teamNames(12)).state()).find("Cross-table") != std::string::npos);
  CHECK(textOf(madeUpRoundRobin(teamNames(13)).state()).find("Cross-table") == std::string::npos);
}

TEST_CASE("a knock-out shows its bracket", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kKnockOut, {"alpha", "beta", "gamma"}));
  maker.add({1, 2, 0, 0}, pairOf({3, 1}, {1, 1})).add({0, 1, 1, 0}, std::nullopt);
  const std::string text = textOf(maker.state());
  INFO(text);
  CHECK(text.find("\nBracket\n  round") != std::string::npos);
  CHECK(text.find("semi-final  alpha") != std::string::npos);
  CHECK(text.find("final") != std::string::npos);
}

TEST_CASE("rounds of a knock-out have names from the final backwards", "[unit]") {
  CHECK(nameOfRound(0, 2) == "final");
  CHECK(nameOfRound(0, 3) == "semi-final");
  CHECK(nameOfRound(1, 3) == "final");
  CHECK(nameOfRound(0, 8) == "quarter-final");
  CHECK(nameOfRound(0, 9) == "round of 16");
  CHECK(nameOfRound(3, 9) == "final");
  CHECK(nameOfRound(4, 9) == "round 5");
}

TEST_CASE("a format of two teams prints the report of its series or test", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"alpha", "beta"}, 2));
  maker.add({0, 1, 0, 0}, pairOf({1, 0}, {1, 0})).add({0, 1, 0, 1}, pairOf({1, 0}, {1, 0}));
  CHECK(textOf(maker.state()).starts_with("alpha against beta: 2 swapped pairs, 4 matches\n"));
  maker.test({-50, 0, 0.05, 0.05});
  CHECK(textOf(maker.state()).starts_with("alpha against beta: inconclusive, no verdict after 2 pairs\n"));
}

TEST_CASE("a name without a visible character becomes a number", "[unit]") {
  const StateMaker maker = madeUpRoundRobin({"alpha", "\xff\xe2\x80\xae"});
  CHECK(shownName(maker.state(), 0) == "alpha");
  CHECK(shownName(maker.state(), 1) == "entrant 2");
}

TEST_CASE("the name of zero has no sign of its own", "[unit]") {
  CHECK(eloText({-0.3, -10.2, 9.6}) == "+0 (-10 to +10)");
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(eloText({infinite, -infinite, infinite}) == "-");
}

TEST_CASE("ratings beyond 700 are shown as such, with a note", "[unit]") {
  CHECK(eloText({966.0, 701.0, 2060.0}) == ">+700");
  CHECK(eloText({966.0, 650.4, 2060.0}) == ">+700 (+650 to >+700)");
  CHECK(eloText({-640.0, -900.2, -300.0}) == "-640 (<-700 to -300)");
  CHECK(eloText({-900.0, -2000.0, -701.0}) == "<-700");
  CHECK(eloText({700.0, 690.0, 700.0}) == "+700 (+690 to +700)");

  const StateMaker maker = madeUpRoundRobin({"alpha", "beta", "gamma"});
  TournamentTable table = tableOf(maker.state());
  const auto noted = [&] {
    const std::vector<std::string> notes = headOf(maker.state(), table).notes;
    return std::any_of(notes.begin(), notes.end(),
                       [](const std::string& note) { return note.find("beyond 700") != std::string::npos; });
  };
  for (Interval& elo : table.ratings.elo) elo = {0.0, -80.0, 120.0};
  CHECK_FALSE(noted());
  CHECK(tournamentJson(maker.state(), table).find("\"elo_beyond_scale\": true") == std::string::npos);
  table.ratings.elo[1] = {-803.0, -1234.0, -640.0};
  CHECK(noted());
  CHECK(tournamentJson(maker.state(), table).find("\"elo_beyond_scale\": true") != std::string::npos);
  for (const std::string& report :
       {tournamentText(maker.state(), table), tournamentMarkdown(maker.state(), table),
        tournamentHtml(maker.state(), table)}) {
    CHECK(report.find("1234") == std::string::npos);
    CHECK(report.find("803") == std::string::npos);
    CHECK(report.find("-640") != std::string::npos);
  }
}
