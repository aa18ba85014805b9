#include "tournament/formats/standings.hpp"

#include <algorithm>
#include <map>

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/formats/played.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

// By entrants, the lower number first.
using Scores = std::map<std::pair<std::size_t, std::size_t>, PairResult>;

/// The table after all meetings. Meetings without a given result are goalless.
std::vector<Standing> tableOf(const TournamentPlan& plan, const Scores& scores) {
  const Played played = playInOrder(plan, [&](const Fixture& fixture) {
    const auto found = scores.find({fixture.a, fixture.b});
    return found == scores.end() ? pairOf(0, 0, 0, 0) : found->second;
  });
  return standingsOf(plan, played.schedule, played.results, played.results.size());
}

std::vector<std::string> reasonsOf(const std::vector<Standing>& table) {
  std::vector<std::string> reasons;
  for (const Standing& line : table) reasons.push_back(line.decided_by);
  return reasons;
}

using Reasons = std::vector<std::string>;

}  // namespace

TEST_CASE("a league counts 3, 1 and 0 points, matches, goals and pairs", "[unit]") {
  const auto table = tableOf(planOf(TournamentFormat::kMatch, 2, 2), {{{0, 1}, pairOf(2, 1, 0, 0)}});
  REQUIRE(table.size() == 2);
  const Standing& first = table[0];
  CHECK(first.entrant == 0);
  CHECK(first.matches == 4);
  CHECK(first.won == 2);
  CHECK(first.drawn == 2);
  CHECK(first.lost == 0);
  CHECK(first.points == 8);
  CHECK(first.goals_for == 4);
  CHECK(first.goals_against == 2);
  CHECK(first.pair_points == 1.5);
  CHECK(table[1].points == 2);
  CHECK(table[1].lost == 2);
  CHECK(table[1].pair_points == 0.5);
  CHECK(table[1].rank == 2);
  CHECK(table[1].decided_by.empty());
}

TEST_CASE("only the first fixtures count that are asked for, and gaps do not", "[unit]") {
  const TournamentPlan plan = planOf(TournamentFormat::kMatch, 2, 3);
  const Schedule schedule = scheduleOf(plan, {});
  const FixtureResults results{pairOf(1, 0, 1, 0), std::nullopt, pairOf(0, 1, 0, 1)};
  CHECK(orderOf(standingsOf(plan, schedule, results, 2)) == "0 1");
  CHECK(orderOf(standingsOf(plan, schedule, results, 3)) == "0 =1");
  CHECK(standingsOf(plan, schedule, results, 9)[0].matches == 4);
  CHECK(orderOf(standingsOf(plan, schedule, {}, 0)) == "0 =1");
}

TEST_CASE("a match that a shoot-out decides gives 3 points to its winner", "[unit]") {
  PairResult pair = pairOf(0, 0, 0, 0);
  pair.legs[1].winner = TeamId::kYellow;  // A wins
  const auto table = tableOf(planOf(TournamentFormat::kMatch, 2), {{{0, 1}, pair}});
  CHECK(table[0].entrant == 0);
  CHECK(table[0].points == 4);
  CHECK(table[1].lost == 1);
  CHECK(table[0].goals_for == 0);
}

TEST_CASE("ties in a league: goal difference, then goals scored", "[unit]") {
  const TournamentPlan plan = planOf(TournamentFormat::kRoundRobin, 4);
  // 0, 1 and 2 beat 3 by different goals. They draw among themselves, 1 and 2 with goals.
  const auto table = tableOf(plan, {{{0, 3}, pairOf(1, 0, 1, 0)},
                                    {{1, 3}, pairOf(3, 0, 1, 0)},
                                    {{2, 3}, pairOf(2, 0, 2, 0)},
                                    {{0, 2}, pairOf(1, 1, 0, 0)}});
  CHECK(orderOf(table) == "2 1 0 3");
  CHECK(reasonsOf(table) == Reasons{"", "goals scored", "goal difference", ""});
}

TEST_CASE("ties in a league: points of the matches between those who are tied", "[unit]") {
  // 0 and 1 have 5 points and goals 2:2. Against 0, 1 won one match and drew the other.
  const auto table =
      tableOf(planOf(TournamentFormat::kRoundRobin, 3),
              {{{0, 1}, pairOf(0, 1, 0, 0)}, {{0, 2}, pairOf(2, 1, 0, 0)}, {{1, 2}, pairOf(0, 0, 1, 2)}});
  CHECK(orderOf(table) == "2 1 0");
  CHECK(reasonsOf(table) == Reasons{"", "goals scored", "points between those tied"});
}

TEST_CASE("ties in a league: goal difference of the matches between those who are tied", "[unit]") {
  // 0 and 1 have 6 points and goals 4:4. Each won one match against the other, 1 by more goals.
  const auto table =
      tableOf(planOf(TournamentFormat::kRoundRobin, 3),
              {{{0, 1}, pairOf(0, 2, 1, 0)}, {{0, 2}, pairOf(3, 1, 0, 1)}, {{1, 2}, pairOf(2, 1, 0, 2)}});
  CHECK(orderOf(table) == "2 1 0");
  CHECK(reasonsOf(table) == Reasons{"", "goals scored", "goal difference between those tied"});
}

TEST_CASE("ties in a league: who is not separated starts again among themselves", "[unit]") {
  // 0, 1 and 2 have 10 points and goals 3:2. Among these three, 0 has 9 points; 1 and 2 have 4 points and
  // goals 1:2. Between 1 and 2, 2 won one match and drew the other.
  const auto table = tableOf(planOf(TournamentFormat::kRoundRobin, 4), {{{0, 1}, pairOf(1, 0, 0, 1)},
                                                                        {{0, 2}, pairOf(1, 0, 1, 0)},
                                                                        {{1, 2}, pairOf(0, 1, 0, 0)},
                                                                        {{0, 3}, pairOf(0, 0, 0, 1)},
                                                                        {{1, 3}, pairOf(1, 0, 1, 0)},
                                                                        {{2, 3}, pairOf(1, 0, 1, 0)}});
  CHECK(orderOf(table) == "0 2 1 3");
  CHECK(reasonsOf(table) == Reasons{"", "points between those tied", "points between those tied", ""});
}

TEST_CASE("ties in a league: who is level in everything shares a rank", "[unit]") {
  // In a circle, each entrant wins against the next and draws with it.
  const auto table =
      tableOf(planOf(TournamentFormat::kRoundRobin, 3),
              {{{0, 1}, pairOf(0, 1, 0, 0)}, {{0, 2}, pairOf(1, 0, 0, 0)}, {{1, 2}, pairOf(0, 0, 0, 1)}});
  CHECK(orderOf(table) == "0 =1 =2");
  CHECK(reasonsOf(table) == Reasons{"", "", ""});
}

TEST_CASE("a walk-over is the last tie-break", "[unit]") {
  const TournamentPlan plan = planOf(TournamentFormat::kMatch, 2);
  PairResult pair = pairOf(1, 0, 0, 1);
  pair.legs[0].faults.teams[0].failures = 3;
  CHECK(orderOf(tableOf(plan, {{{0, 1}, pair}})) == "0 =1");
  pair.legs[1].faults.teams[1].forfeited = true;  // A plays yellow
  const auto table = tableOf(plan, {{{0, 1}, pair}});
  CHECK(orderOf(table) == "1 0");
  CHECK(reasonsOf(table) == Reasons{"", "fewer walk-overs"});
}

TEST_CASE("each group has a table of its own", "[unit]") {
  TournamentPlan plan = planOf(TournamentFormat::kRoundRobin, 6);
  plan.groups = 2;
  const Played played = playInOrder(plan, orderedPlay([](auto a, auto b) { return a > b; }));
  const auto table = standingsOf(plan, played.schedule, played.results, played.results.size());
  CHECK(orderOf(table) == "4 3 0 5 2 1");
  std::vector<int> groups, ranks;
  for (const Standing& line : table) groups.push_back(line.group), ranks.push_back(line.rank);
  CHECK(groups == std::vector<int>{0, 0, 0, 1, 1, 1});
  CHECK(ranks == std::vector<int>{1, 2, 3, 1, 2, 3});
}

TEST_CASE("a gauntlet counts per match: many matches are no advantage", "[unit]") {
  const TournamentPlan plan = planOf(TournamentFormat::kGauntlet, 4);
  // 0 wins a third of its matches, 1 loses all, 2 and 3 win all.
  const auto table = tableOf(
      plan, {{{0, 1}, pairOf(1, 0, 1, 0)}, {{0, 2}, pairOf(0, 1, 0, 1)}, {{0, 3}, pairOf(0, 2, 0, 2)}});
  CHECK(orderOf(table) == "3 2 0 1");
  CHECK(reasonsOf(table) == Reasons{"", "goal difference per match", "", ""});
  CHECK(table[2].points == 6);
}

TEST_CASE("a Swiss table by hand: points of pairs with a bye, Buchholz, Sonneborn-Berger", "[unit]") {
  TournamentPlan plan = planOf(TournamentFormat::kSwiss, 5, 2);
  plan.rounds = 2;
  const Played played = playInOrder(plan, orderedPlay([](auto a, auto b) { return a < b; }));
  // Round 1: 0-2, 1-3, bye 4. Round 2: 0-1, 4-2, bye 3. Two pairs each.
  const auto table = standingsOf(plan, played.schedule, played.results, played.results.size());
  std::map<std::size_t, double> points;
  std::map<std::size_t, int> byes;
  for (const Standing& line : table) points[line.entrant] = line.pair_points, byes[line.entrant] = line.byes;
  CHECK(points == std::map<std::size_t, double>{{0, 4}, {1, 2}, {2, 2}, {3, 2}, {4, 2}});
  CHECK(byes == std::map<std::size_t, int>{{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 1}});
  // Buchholz: 1 and 2 have 4 + 2; 3 and 4 have 2, and 2 from the bye. Sonneborn-Berger: 1 beat 3 (2), 2 beat
  // 4 (2), which is level. Goals are level too. 3 and 4 lost to 1 and 2.
  CHECK(orderOf(table) == "0 1 =2 3 =4");
  CHECK(reasonsOf(table) == Reasons{"", "", "", "Buchholz", ""});
}

TEST_CASE("a bye counts once its round has begun to count", "[unit]") {
  TournamentPlan plan = planOf(TournamentFormat::kSwiss, 3);
  plan.rounds = 2;
  const Played played = playInOrder(plan, randomPlay(2));
  REQUIRE(played.schedule.fixtures.size() == 2);
  const auto byes = [&](std::size_t counted) {
    int sum = 0;
    for (const Standing& line : standingsOf(plan, played.schedule, played.results, counted)) sum += line.byes;
    return sum;
  };
  CHECK(byes(0) == 0);
  CHECK(byes(1) == 1);
  CHECK(byes(2) == 2);
}

TEST_CASE("in every table sums agree and ranks rise", "[unit]") {
  for (std::size_t f = 1; f < kTournamentFormats; ++f) {
    const auto format = static_cast<TournamentFormat>(f);
    for (std::size_t entrants = 2; entrants <= 20; ++entrants) {
      const TournamentPlan plan = planOf(format, entrants, 2);
      const Played played = playInOrder(plan, randomPlay(entrants));
      for (const std::size_t counted : {played.results.size() / 2, played.results.size()}) {
        const auto table = standingsOf(plan, played.schedule, played.results, counted);
        REQUIRE(table.size() == entrants);
        int won = 0, lost = 0, difference = 0, matches = 0;
        double pair_points = 0.0;
        std::vector<bool> seen(entrants);
        for (std::size_t i = 0; i < table.size(); ++i) {
          const Standing& line = table[i];
          seen[line.entrant] = true;
          won += line.won, lost += line.lost, matches += line.matches;
          difference += line.goals_for - line.goals_against;
          pair_points += line.pair_points;
          if (format == TournamentFormat::kSwiss) pair_points -= line.byes * plan.pairs;
          CHECK(line.won + line.drawn + line.lost == line.matches);
          CHECK(line.points == 3 * line.won + line.drawn);
          CHECK((line.rank == static_cast<int>(i) + 1 || line.rank == table[i - 1].rank));
        }
        CHECK(std::count(seen.begin(), seen.end(), true) == static_cast<std::ptrdiff_t>(entrants));
        CHECK(won == lost);
        CHECK(difference == 0);
        CHECK(matches == static_cast<int>(4 * counted));
        CHECK(pair_points == static_cast<double>(counted));
      }
    }
  }
}
