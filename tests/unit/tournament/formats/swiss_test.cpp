#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/tournament/formats/played.hpp"
#include "tournament/formats/swiss_pairing.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

/// Whether all of `left` can be paired, found by trying all pairings.
bool pairable(const OpenMeetings& open, std::vector<std::size_t> left) {
  if (left.empty()) return true;
  const std::size_t first = left.back();
  left.pop_back();
  for (std::size_t i = 0; i < left.size(); ++i) {
    std::vector<std::size_t> rest = left;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    if (open.has(first, left[i]) && pairable(open, std::move(rest))) return true;
  }
  return false;
}

OpenMeetings randomMeetings(std::size_t size, std::uint32_t percent, Rng& rng) {
  OpenMeetings open(size);
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (rng.below(100) >= percent) open.close(a, b);
    }
  }
  return open;
}

std::vector<std::size_t> allBut(std::size_t size, std::set<std::size_t> gone) {
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < size; ++i) {
    if (!gone.contains(i)) left.push_back(i);
  }
  return left;
}

/// Checks a Swiss tournament: nobody meets twice, each entrant plays or rests in each round, nobody rests
/// twice.
void checkRounds(const TournamentPlan& plan, const Schedule& schedule) {
  std::set<std::pair<std::size_t, std::size_t>> meetings;
  std::map<int, std::set<std::size_t>> rounds;
  for (const Fixture& fixture : schedule.fixtures) {
    REQUIRE(meetings.insert(std::minmax(fixture.a, fixture.b)).second);
    REQUIRE(rounds[fixture.round].insert(fixture.a).second);
    REQUIRE(rounds[fixture.round].insert(fixture.b).second);
  }
  REQUIRE(static_cast<int>(rounds.size()) == roundsOf(plan));
  std::set<std::size_t> rested;
  const std::size_t entrants = plan.entrants.size();
  for (const auto& [round, players] : rounds) {
    const auto resting = allBut(entrants, players);
    REQUIRE(resting.size() == entrants % 2);
    for (const std::size_t entrant : resting) REQUIRE(rested.insert(entrant).second);
  }
}

}  // namespace

TEST_CASE("a perfect matching is found exactly when there is one, also after settled pairs", "[unit]") {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Rng rng(seed, kTestStream);
    const std::size_t size = 2 + 2 * rng.below(5);
    const OpenMeetings open = randomMeetings(size, 15 + rng.below(50), rng);
    PerfectMatching matching(open);
    CAPTURE(seed, size);
    REQUIRE(matching.exists() == pairable(open, allBut(size, {})));
    if (!matching.exists()) continue;
    ++found;
    std::set<std::size_t> gone;
    for (std::size_t a = 0; a < size; ++a) {
      for (std::size_t b = a + 1; b < size; ++b) {
        if (gone.contains(a) || gone.contains(b)) continue;
        std::set<std::size_t> next = gone;
        next.insert({a, b});
        const bool possible = open.has(a, b) && pairable(open, allBut(size, next));
        REQUIRE(matching.settle(a, b) == possible);
        if (possible) gone = next;
      }
    }
    REQUIRE(gone.size() == size);
  }
  CHECK(found > 100);
  CHECK(found < 500);
}

TEST_CASE("an odd cycle is searched through: a blossom", "[unit]") {
  // A path 0-1, a triangle 1-2-3 and a path 3-4-5: only 0-1, 2-3, 4-5 pairs all entrants.
  OpenMeetings open = OpenMeetings(6);
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const bool edge = a == b + 1 || (a == 3 && b == 1);
      if (!edge) open.close(a, b);
    }
  }
  PerfectMatching matching(open);
  REQUIRE(matching.exists());
  CHECK_FALSE(matching.settle(1, 2));
  CHECK_FALSE(matching.settle(1, 3));
  CHECK_FALSE(matching.settle(3, 4));
  CHECK(matching.settle(2, 3));
  CHECK(matching.settle(0, 1));
  CHECK(matching.settle(4, 5));
}

TEST_CASE("Swiss pairings by hand", "[unit]") {
  SwissPairing six(6, 3);
  CHECK(six.next({0, 0, 0, 0, 0, 0}) == Pairing{{0, 3}, {1, 4}, {2, 5}});
  // 0, 1 and 5 won. 0 meets 1; 5 meets the best loser that it has not met, since 2 was its opponent.
  CHECK(six.next({1, 1, 0, 0, 0, 1}) == Pairing{{0, 1}, {5, 3}, {2, 4}});
  SwissPairing five(5, 2);
  CHECK(five.next({0, 0, 0, 0, 0}) == Pairing{{0, 2}, {1, 3}, {4, 5}});
  // The bye of 4 counts as a win. 3 is the last without a bye, so it rests in this round.
  CHECK(five.next({1, 1, 0, 0, 1}) == Pairing{{0, 1}, {4, 2}, {3, 5}});
}

TEST_CASE("a pairing that leaves others without an opponent is passed over", "[unit]") {
  SwissPairing pairing(4, 2);
  CHECK(pairing.next({0, 0, 0, 0}) == Pairing{{0, 2}, {1, 3}});
  // 0 and 2 lead, but have met, so both meet losers.
  CHECK(pairing.next({1, 0, 1, 0}) == Pairing{{0, 1}, {2, 3}});
  SwissPairing six(6, 3);
  six.next({0, 0, 0, 0, 0, 0});  // 0-3 1-4 2-5
  six.next({2, 2, 2, 1, 1, 0});  // 0-1 2-3 4-5
  // 1 would meet 3 next, but that would leave 4 and 5, who have met.
  CHECK(six.next({3, 2, 3, 1, 1, 0}) == Pairing{{0, 2}, {1, 5}, {3, 4}});
}

TEST_CASE("nobody meets twice or rests twice, for all numbers of rounds below the entrants", "[unit]") {
  for (std::size_t entrants = 2; entrants <= 40; ++entrants) {
    const int half = static_cast<int>(entrants / 2), most = static_cast<int>(entrants - 1);
    std::set<int> all{0, half, half + 1};
    if (entrants <= 16 || entrants % 10 == 0) all.insert({3, most - 1, most});
    for (int rounds = 1; rounds <= most && entrants <= 10; ++rounds) all.insert(rounds);
    for (const int rounds : all) {
      TournamentPlan plan = planOf(TournamentFormat::kSwiss, entrants);
      plan.rounds = rounds;
      if (!validateFormat(plan)) continue;
      for (std::uint64_t seed = 0; seed < 2; ++seed) {
        CAPTURE(entrants, rounds, seed);
        checkRounds(plan, playInOrder(plan, randomPlay(seed)).schedule);
      }
      const auto upset = orderedPlay([](auto a, auto b) { return a > b; });
      checkRounds(plan, playInOrder(plan, upset).schedule);
    }
  }
}

TEST_CASE("reserved rounds have no pair in common, whatever the points", "[unit]") {
  for (const std::size_t entrants : {2u, 3u, 7u, 12u, 33u, 70u, 81u}) {
    const std::size_t places = entrants + entrants % 2;
    CAPTURE(entrants);
    ReservedRounds rounds(places, places - 1);
    Rng rng(entrants, kTestStream);
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t round = 0; round + 1 < places; ++round) {
      REQUIRE_FALSE(rounds.empty());
      std::vector<double> points(entrants);
      for (double& value : points) value = rng.below(40) / 4.0;
      const Pairing next = rounds.take(points);
      CHECK(next.size() == places / 2);
      std::set<std::size_t> players;
      for (const auto& [a, b] : next) {
        CHECK(pairs.insert(std::minmax(a, b)).second);
        CHECK((b == entrants || points[a] >= points[b]));
        players.insert({a, b});
      }
      CHECK(players.size() == places);
      if (entrants < places) CHECK(next.back().second == entrants);
    }
    CHECK(rounds.empty());
  }
}

TEST_CASE("exchanged cycles make a reserved round more equal", "[unit]") {
  // Two rounds of the circle method for 10 places can form several cycles.
  constexpr std::size_t kPlaces = 10;
  const auto cost = [](const Pairing& pairs, const std::vector<double>& points) {
    double sum = 0.0;
    for (const auto& [a, b] : pairs) sum += (points[a] - points[b]) * (points[a] - points[b]);
    return sum;
  };
  int better = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Rng rng(seed, kTestStream);
    std::vector<double> points(kPlaces);
    for (double& value : points) value = rng.below(20) / 4.0;
    double least = 1e9;
    for (std::size_t round = 0; round + 1 < kPlaces; ++round) {
      least = std::min(least, cost(circleRound(kPlaces, round), points));
    }
    const double reached = cost(ReservedRounds(kPlaces, kPlaces - 1).take(points), points);
    CHECK(reached <= least);
    better += reached < least;
  }
  CHECK(better > 10);
}

TEST_CASE("rounds after the next one are found, or the reserved ones stay", "[unit]") {
  // Six entrants after one round of the complete graph: five rounds in all are always possible.
  ReservedRounds rounds(6, 5);
  OpenMeetings open(6);
  for (const auto& [a, b] : Pairing{{0, 1}, {2, 3}, {4, 5}}) open.close(a, b);
  REQUIRE(rounds.renew(open));
  for (int round = 0; round < 4; ++round) {
    for (const auto& [a, b] : rounds.take(std::vector<double>(6))) {
      CHECK(open.has(a, b));
      open.close(a, b);
    }
  }
  CHECK(rounds.empty());
  // After three rounds of six entrants only two triangles are left, so there is no fourth round.
  ReservedRounds two(6, 2);
  OpenMeetings triangles(6);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 3; b < 6; ++b) triangles.close(a, b);
  }
  CHECK_FALSE(two.renew(triangles));
  CHECK_FALSE(two.empty());
}

TEST_CASE("opponents of a Swiss round have about equal points, in short and long tournaments", "[unit]") {
  constexpr std::size_t kEntrants = 16, kMeetings = kEntrants / 2;
  constexpr int kCompared = 4;  // number of rounds; in a long tournament the last ones have no choice
  const int rounds = GENERATE(4, 8, 9, 12, 15);
  TournamentPlan plan = planOf(TournamentFormat::kSwiss, kEntrants);
  plan.rounds = rounds;
  const Played played = playInOrder(plan, orderedPlay([](auto a, auto b) { return a < b; }));
  std::vector<double> points(kEntrants);
  double between_opponents = 0.0, between_all = 0.0;  // mean difference of points before the meetings
  for (int round = 0; round < kCompared; ++round) {
    const auto* fixtures = &played.schedule.fixtures[static_cast<std::size_t>(round) * kMeetings];
    for (const double a : points) {
      for (const double b : points) between_all += std::abs(a - b) / (kEntrants * (kEntrants - 1));
    }
    for (std::size_t i = 0; i < kMeetings; ++i) {
      between_opponents += std::abs(points[fixtures[i].a] - points[fixtures[i].b]) / kMeetings;
    }
    for (std::size_t i = 0; i < kMeetings; ++i) points[std::min(fixtures[i].a, fixtures[i].b)] += 1.0;
  }
  INFO(rounds << " rounds: " << between_opponents << " between opponents, " << between_all << " between all");
  CHECK(between_opponents < 0.5 * between_all);
}
