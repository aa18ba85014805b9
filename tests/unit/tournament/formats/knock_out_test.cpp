#include <set>

#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/tournament/formats/played.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

const auto kBetterSeed = orderedPlay([](auto a, auto b) { return a < b; });

std::string textOf(const std::vector<KnockOutTie>& ties) {
  const auto name = [](std::optional<std::size_t> entrant) {
    return entrant ? std::to_string(*entrant) : "?";
  };
  std::string text;
  for (const KnockOutTie& tie : ties) {
    text += std::to_string(tie.round) + (tie.third_place ? "third:" : ":") + name(tie.a) + "-" + name(tie.b) +
            "=" + name(tie.winner) + " ";
  }
  return text;
}

/// A tie of two entrants with one regular pair. `pairs` are the results by start.
KnockOutTie tieOf(const std::vector<PairResult>& pairs) {
  const TournamentPlan plan = planOf(TournamentFormat::kKnockOut, 2);
  const Played played = playInOrder(plan, [&](const Fixture& fixture) { return pairs.at(fixture.start); });
  CHECK(played.results.size() == pairs.size());
  return bracketOf(plan, played.results).front();
}

}  // namespace

TEST_CASE("the best seeds of a bracket meet as late as possible", "[unit]") {
  const auto order = [](std::size_t entrants) {
    std::vector<std::size_t> seeds;
    for (const KnockOutTie& tie : bracketOf(planOf(TournamentFormat::kKnockOut, entrants), {})) {
      if (tie.round == 0) seeds.push_back(*tie.a), seeds.push_back(*tie.b);
    }
    return seeds;
  };
  CHECK(order(8) == std::vector<std::size_t>{0, 7, 3, 4, 1, 6, 2, 5});
  CHECK(order(16) == std::vector<std::size_t>{0, 15, 7, 8, 3, 12, 4, 11, 1, 14, 6, 9, 2, 13, 5, 10});
}

TEST_CASE("a bracket of five by hand: three byes, a match for the third place", "[unit]") {
  const TournamentPlan plan = planOf(TournamentFormat::kKnockOut, 5);
  CHECK(textOf(bracketOf(plan, {})) ==
        "0:0-?=0 0:3-4=? 0:1-?=1 0:2-?=2 1:0-?=? 1:1-2=? 2:?-?=? 2third:?-?=? ");
  const Played played = playInOrder(plan, kBetterSeed);
  CHECK(textOf(bracketOf(plan, played.results)) ==
        "0:0-?=0 0:3-4=3 0:1-?=1 0:2-?=2 1:0-3=0 1:1-2=1 2:0-1=0 2third:3-2=2 ");
  const auto table = standingsOf(plan, played.schedule, played.results, 5);
  CHECK(orderOf(table) == "0 1 2 3 4");
  CHECK(table[0].byes == 1);
  CHECK(table[1].decided_by == "round reached");
  CHECK(table[3].decided_by == "match for the third place");
  CHECK(table[4].byes == 0);
  // With three entrants, the loser of the only semi-final is third without a match.
  CHECK(textOf(bracketOf(planOf(TournamentFormat::kKnockOut, 3), {})) == "0:0-?=0 0:1-2=? 1:0-?=? ");
}

TEST_CASE("the table while a knock-out is under way: the same round, then who is still in", "[unit]") {
  const TournamentPlan plan = planOf(TournamentFormat::kKnockOut, 8);
  const Played played = playInOrder(plan, kBetterSeed);
  // The results of two of the four quarter-finals: 0 beat 7, 3 beat 4.
  const auto table = standingsOf(plan, played.schedule, played.results, 2);
  CHECK(orderOf(table) == "0 =3 1 =2 =5 =6 4 =7");
  CHECK(table[2].decided_by == "round reached");
  CHECK(table[6].decided_by == "still in");
  const auto last = standingsOf(plan, played.schedule, played.results, played.results.size());
  CHECK(orderOf(last) == "0 1 2 3 4 =5 =6 =7");
}

TEST_CASE("what decides a tie: points, goals, further pairs one at a time, seeding", "[unit]") {
  const PairResult level = pairOf(1, 0, 0, 1), a_wins = pairOf(1, 0, 0, 0), b_wins = pairOf(0, 1, 0, 0);
  CHECK(tieOf({a_wins}).decided_by == "points");
  CHECK(tieOf({b_wins}).winner == 1u);
  const KnockOutTie goals = tieOf({pairOf(1, 0, 0, 3)});
  CHECK(goals.decided_by == "goal difference");
  CHECK(goals.winner == 1u);
  CHECK(goals.points_a == 1.0);
  CHECK(goals.goals_b == 3);
  const KnockOutTie extra = tieOf({level, level, b_wins});
  CHECK(extra.decided_by == "extra pair 2");
  CHECK(extra.winner == 1u);
  CHECK(extra.points_b == 3.5);
  const KnockOutTie seeding = tieOf({level, level, level, level});
  CHECK(seeding.decided_by == "seeding");
  CHECK(seeding.winner == 0u);
}

TEST_CASE("a match that a shoot-out decides counts by its winner, not its score", "[unit]") {
  PairResult pair = pairOf(0, 0, 2, 2);
  pair.legs[0].winner = TeamId::kYellow;  // B wins
  pair.legs[1].winner = TeamId::kBlue;    // B wins
  const KnockOutTie tie = tieOf({pair});
  CHECK(tie.winner == 1u);
  CHECK(tie.points_b == 2.0);
  CHECK(tie.goals_a == 2);
}

TEST_CASE("brackets are consistent for any number of entrants and any results", "[unit]") {
  for (std::size_t entrants = 2; entrants <= 40; ++entrants) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      CAPTURE(entrants, seed);
      const TournamentPlan plan = planOf(TournamentFormat::kKnockOut, entrants, 2);
      const Played played = playInOrder(plan, randomPlay(seed));
      const auto ties = bracketOf(plan, played.results);
      std::vector<int> lost(entrants);
      std::vector<std::size_t> before, now;  // winners of the previous and the present round
      std::size_t played_ties = 0;
      for (std::size_t i = 0, round = 0; i < ties.size(); ++i) {
        const KnockOutTie& tie = ties[i];
        if (tie.round != static_cast<int>(round)) ++round, before = now, now.clear();
        REQUIRE(tie.winner);
        REQUIRE((tie.winner == tie.a || tie.winner == tie.b));
        if (tie.decided_by == "bye") {
          CHECK(round == 0);
          CHECK(*tie.a < 64 - entrants);
        } else {
          ++played_ties;
          if (!tie.third_place) ++lost[tie.winner == tie.a ? *tie.b : *tie.a];
        }
        if (round > 0 && !tie.third_place) {
          CHECK(tie.a == before[2 * now.size()]);
          CHECK(tie.b == before[2 * now.size() + 1]);
        }
        now.push_back(*tie.winner);
      }
      CHECK(played_ties == entrants - (entrants >= 4 ? 0 : 1));
      const std::size_t champion = entrants >= 4 ? *ties[ties.size() - 2].winner : *ties.back().winner;
      for (std::size_t e = 0; e < entrants; ++e) CHECK(lost[e] == (e == champion ? 0 : 1));
      const auto table = standingsOf(plan, played.schedule, played.results, played.results.size());
      CHECK(table.front().entrant == champion);
      CHECK(table.size() == entrants);
    }
  }
}

TEST_CASE("byes go to the top seeds", "[unit]") {
  for (std::size_t entrants = 2; entrants <= 40; ++entrants) {
    const TournamentPlan plan = planOf(TournamentFormat::kKnockOut, entrants);
    std::size_t size = 2;
    while (size < entrants) size *= 2;
    std::set<std::size_t> byes, wanted;
    for (std::size_t i = 0; i < size - entrants; ++i) wanted.insert(i);
    for (const KnockOutTie& tie : bracketOf(plan, {})) {
      if (tie.decided_by == "bye") byes.insert(*tie.winner);
    }
    CHECK(byes == wanted);
  }
}
