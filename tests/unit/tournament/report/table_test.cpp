#include "tournament/report/table.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/counted_results.hpp"

using namespace fulbito;
using namespace fulbito::test;

TEST_CASE("meetings are counted from both sides, whichever team is A", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kRoundRobin, {"a", "b", "c"}));
  maker.state().plan.book.kinds = {StartKind::kKickOff, StartKind::kPenalty};
  maker.add({0, 1, 0, 0}, pairOf({3, 1}, {0, 0})).add({1, 0, 0, 1}, pairOf({2, 0}, {0, 1}));
  const TournamentTable table = tableOf(maker.state());
  const MeetingSummary& ab = table.cross[0][1];
  CHECK(ab.pairs == 2);
  CHECK(ab.won == 2);
  CHECK(ab.drawn == 1);
  CHECK(ab.lost == 1);
  CHECK(ab.goals_for == 3 + 0 + 0 + 1);
  CHECK(ab.goals_against == 1 + 0 + 2 + 0);
  CHECK(ab.points_share.value == Approx((0.75 + 0.5) / 2));
  CHECK(table.cross[1][0].won == 1);
  CHECK(table.cross[1][0].points_share.value == Approx(1 - ab.points_share.value));
  CHECK(table.cross[0][2].pairs == 0);
  CHECK(table.starts[0][static_cast<std::size_t>(StartKind::kKickOff)].points_share.value == Approx(0.75));
  CHECK(table.starts[0][static_cast<std::size_t>(StartKind::kPenalty)].points_share.value == Approx(0.5));
  CHECK(table.totals[0].pairs == 2);
  CHECK(table.totals[2].pairs == 0);
}

TEST_CASE("a winner by shoot-out wins the match though the score is level", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kKnockOut, {"a", "b"}));
  PairResult pair = pairOf({1, 1}, {1, 1});
  pair.legs[1].winner = TeamId::kYellow;  // A wins the second leg
  maker.add({0, 1, 0, 0}, pair);
  const TournamentTable table = tableOf(maker.state());
  CHECK(table.cross[0][1].won == 1);
  CHECK(table.cross[0][1].drawn == 1);
  CHECK(table.cross[0][1].points_share.value == Approx(0.75));
}

TEST_CASE("only fixtures that count count", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"a", "b"}, 3));
  for (std::size_t i = 0; i < 3; ++i) maker.add({0, 1, 0, i}, pairOf({1, 0}, {1, 0}));
  maker.state().counted = 2;
  CHECK(tableOf(maker.state()).totals[0].pairs == 2);
  maker.state().results[0].reset();
  CHECK(tableOf(maker.state()).totals[0].pairs == 1);
}

TEST_CASE("a fault belongs to the team that made it, its worst one counts", "[unit]") {
  MatchResult result = resultOf(0, 3);
  result.outcome = MatchOutcome::kCrash;
  result.faults.teams[0].failures = 2;
  result.faults.teams[0].late = 5;
  result.faults.teams[1].late = 1;
  CHECK(outcomeOfSeat(result, 0) == MatchOutcome::kCrash);
  CHECK(outcomeOfSeat(result, 1) == MatchOutcome::kSlow);
  result.outcome = MatchOutcome::kForfeit;
  result.faults.teams[0].forfeited = true;
  CHECK(outcomeOfSeat(result, 0) == MatchOutcome::kForfeit);
  result.faults.teams[1] = {};
  CHECK(outcomeOfSeat(result, 1) == MatchOutcome::kNormal);
  MatchResult absent = resultOf(10, 0);
  absent.outcome = MatchOutcome::kForfeit;  // yellow is absent, so it has no faults
  CHECK(outcomeOfSeat(absent, 0) == MatchOutcome::kNormal);
  CHECK(outcomeOfSeat(absent, 1) == MatchOutcome::kForfeit);
  MatchResult mercy = resultOf(10, 0);
  mercy.outcome = MatchOutcome::kMercy;
  CHECK(outcomeOfSeat(mercy, 0) == MatchOutcome::kNormal);
  CHECK(outcomeOfSeat(mercy, 1) == MatchOutcome::kMercy);
  MatchResult illegal = resultOf(0, 0);
  illegal.faults.teams[1].not_finite = 1;
  CHECK(outcomeOfSeat(illegal, 1) == MatchOutcome::kIllegal);
}

TEST_CASE("faults of a table name the last failure of each team", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"a", "b"}, 2));
  for (const char* why : {"first", "second"}) {
    PairResult pair = pairOf({0, 1}, {0, 0});
    pair.legs[0].faults.teams[0].failures = 1;
    pair.legs[0].faults.teams[0].failure = why;
    pair.legs[0].outcome = MatchOutcome::kCrash;
    maker.add({0, 1, 0, 0}, pair);
  }
  const TournamentTable table = tableOf(maker.state());
  CHECK(table.faults[0].of(MatchOutcome::kCrash) == 2);
  CHECK(table.faults[0].of(MatchOutcome::kNormal) == 2);
  CHECK(table.faults[0].last_failure == "second");
  CHECK(table.faults[1].of(MatchOutcome::kNormal) == 4);
}

TEST_CASE("the course has a step per twentieth, and ends at the rating", "[unit]") {
  const StateMaker maker = madeUpRoundRobin(teamNames(10), 2);  // 90 fixtures
  const TournamentTable table = tableOf(maker.state());
  REQUIRE(table.course.size() == 10);
  for (std::size_t i = 0; i < table.course.size(); ++i) {
    REQUIRE(table.course[i].size() == kCourseSteps);
    CHECK(table.course[i].back() == table.ratings.elo[i].value);
  }
  // The first 4 fixtures are those of the first team against the next four.
  CHECK(std::isfinite(table.course[0][0]));
  CHECK(std::isnan(table.course[9][0]));
  CHECK(tableOf(madeUpRoundRobin(teamNames(3)).state()).course[0].size() == 3);
  CHECK(tableOf(StateMaker(planOf(TournamentFormat::kSwiss, {"a", "b"})).state()).course[0].empty());
}
