#include "tournament/formats/schedule.hpp"

#include <algorithm>
#include <ctime>
#include <map>
#include <set>
#include <tuple>

#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/tournament/formats/played.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr std::size_t kMostTested = 40;
#ifdef NDEBUG
constexpr double kMostTime = 0.3;  // [s]
#else
// [s] for a build for debugging or with sanitizers; enough for linear time only.
constexpr double kMostTime = 10.0;
#endif

std::string textOf(const Schedule& schedule) {
  std::string text;
  for (const auto& [a, b, round, start] : schedule.fixtures) {
    text += std::to_string(round) + ":" + std::to_string(a) + "-" + std::to_string(b) + "/" +
            std::to_string(start) + " ";
  }
  return text;
}

using Meeting = std::pair<std::size_t, std::size_t>;
Meeting meetingOf(const Fixture& fixture) { return std::minmax(fixture.a, fixture.b); }

}  // namespace

TEST_CASE("fixed formats by hand", "[unit]") {
  CHECK(textOf(scheduleOf(planOf(TournamentFormat::kMatch, 2, 3), {})) == "0:0-1/0 1:0-1/1 2:0-1/2 ");
  CHECK(textOf(scheduleOf(planOf(TournamentFormat::kGauntlet, 3, 2), {})) ==
        "0:0-1/0 0:0-2/0 1:0-1/1 1:0-2/1 ");
  CHECK(textOf(scheduleOf(planOf(TournamentFormat::kRoundRobin, 4), {})) ==
        "0:0-3/0 0:1-2/0 1:0-2/0 1:1-3/0 2:0-1/0 2:2-3/0 ");
  CHECK(textOf(scheduleOf(planOf(TournamentFormat::kRoundRobin, 3, 2), {})) ==
        "0:1-2/0 1:0-2/0 2:0-1/0 3:1-2/1 4:0-2/1 5:0-1/1 ");
  TournamentPlan groups = planOf(TournamentFormat::kRoundRobin, 5);
  groups.groups = 2;
  CHECK(groupsOf(groups) == std::vector<std::vector<std::size_t>>{{0, 3, 4}, {1, 2}});
  CHECK(textOf(scheduleOf(groups, {})) == "0:3-4/0 0:1-2/0 1:0-4/0 2:0-3/0 ");
}

TEST_CASE("every format ends, only grows, and does not depend on the order of play", "[unit]") {
  const auto format = static_cast<TournamentFormat>(GENERATE(range(1, static_cast<int>(kTournamentFormats))));
  for (std::size_t entrants = 2; entrants <= kMostTested; ++entrants) {
    TournamentPlan plan = planOf(format, entrants, 1 + static_cast<int>(entrants % 3));
    if (format == TournamentFormat::kRoundRobin && entrants >= 8) plan.groups = 3;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      CAPTURE(static_cast<int>(format), entrants, seed);
      Rng rng(seed, kTestStream, entrants);
      const Played ordered = playInOrder(plan, randomPlay(seed));
      CHECK(sameSchedule(playInDisorder(plan, randomPlay(seed), rng).schedule, ordered.schedule));
      for (const Fixture& fixture : ordered.schedule.fixtures) {
        REQUIRE(fixture.a != fixture.b);
        REQUIRE(std::max(fixture.a, fixture.b) < entrants);
      }
    }
  }
}

TEST_CASE("nobody plays the same start against the same opponent twice", "[unit]") {
  const auto format = static_cast<TournamentFormat>(GENERATE(range(1, static_cast<int>(kTournamentFormats))));
  for (std::size_t entrants = 2; entrants <= kMostTested; ++entrants) {
    const Played played = playInOrder(planOf(format, entrants, 2), randomPlay(entrants));
    std::set<std::pair<Meeting, std::size_t>> pairs;
    std::map<Meeting, std::size_t> starts;
    for (const Fixture& fixture : played.schedule.fixtures) {
      CHECK(pairs.emplace(meetingOf(fixture), fixture.start).second);
      CHECK(starts[meetingOf(fixture)]++ == fixture.start);  // starts count from 0 without a gap
    }
  }
}

TEST_CASE("in a round robin all of a group meet once per start, and all play about equally early", "[unit]") {
  for (std::size_t entrants = 2; entrants <= kMostTested; ++entrants) {
    CAPTURE(entrants);
    const Schedule schedule = scheduleOf(planOf(TournamentFormat::kRoundRobin, entrants, 2), {});
    std::set<std::tuple<Meeting, std::size_t>> meetings;
    std::vector<int> played(entrants);
    std::map<int, std::set<std::size_t>> rounds;
    for (const Fixture& fixture : schedule.fixtures) {
      meetings.emplace(meetingOf(fixture), fixture.start);
      CHECK(rounds[fixture.round].insert(fixture.a).second);
      CHECK(rounds[fixture.round].insert(fixture.b).second);
      ++played[fixture.a], ++played[fixture.b];
      const auto [least, most] = std::minmax_element(played.begin(), played.end());
      CHECK(*most - *least <= (entrants % 2 == 0 ? 1 : 2));
    }
    CHECK(meetings.size() == schedule.fixtures.size());
    CHECK(schedule.fixtures.size() == entrants * (entrants - 1));
  }
}

TEST_CASE("groups are as equal as possible and play among themselves only", "[unit]") {
  for (std::size_t entrants = 4; entrants <= kMostTested; ++entrants) {
    for (int count = 2; count <= static_cast<int>(entrants / 2); ++count) {
      TournamentPlan plan = planOf(TournamentFormat::kRoundRobin, entrants);
      plan.groups = count;
      const auto groups = groupsOf(plan);
      std::vector<std::size_t> group(entrants), wanted, played(entrants);
      std::size_t dealt = 0;
      for (std::size_t g = 0; g < groups.size(); ++g) {
        CHECK((groups[g].size() == entrants / groups.size() ||
               groups[g].size() == (entrants - 1) / groups.size() + 1));
        dealt += groups[g].size();
        for (const std::size_t entrant : groups[g]) group[entrant] = g;
      }
      CHECK(dealt == entrants);
      for (const Fixture& fixture : scheduleOf(plan, {}).fixtures) {
        CHECK(group[fixture.a] == group[fixture.b]);
        ++played[fixture.a], ++played[fixture.b];
      }
      for (std::size_t i = 0; i < entrants; ++i) CHECK(played[i] == groups[group[i]].size() - 1);
    }
  }
}

TEST_CASE("a ladder by hand: the lower one takes the upper's place if it wins", "[unit]") {
  TournamentPlan plan = planOf(TournamentFormat::kLadder, 3, 2);
  plan.rounds = 3;
  // 2 is the strongest, then 0. Entrants 1 and 2 exchange places in the second round, 0 and 2 in the third.
  const Played played =
      playInOrder(plan, orderedPlay([](auto a, auto b) { return a == 2 || (b != 2 && a < b); }));
  CHECK(textOf(played.schedule) == "0:0-1/0 0:0-1/1 1:1-2/0 1:1-2/1 2:0-2/0 2:0-2/1 ");
  CHECK(orderOf(standingsOf(plan, played.schedule, played.results, 6)) == "2 0 1");
  // Without its last result, the third round does not count.
  CHECK(orderOf(standingsOf(plan, played.schedule, played.results, 5)) == "0 2 1");
}

TEST_CASE("who meets again on a ladder plays new starts", "[unit]") {
  TournamentPlan plan = planOf(TournamentFormat::kLadder, 2, 2);
  plan.rounds = 3;
  const Played played = playInOrder(plan, randomPlay(3));
  REQUIRE(played.schedule.fixtures.size() == 4);
  CHECK(played.schedule.fixtures[2].round == 2);
  CHECK(played.schedule.fixtures[2].start == 2);
}

TEST_CASE("a ladder of n sorts any order in its default of n rounds if the better ones win", "[unit]") {
  for (std::size_t entrants = 2; entrants <= kMostTested; ++entrants) {
    const TournamentPlan plan = planOf(TournamentFormat::kLadder, entrants);
    // The worst case: the seeding is exactly the reverse order of strength.
    const Played played = playInOrder(plan, orderedPlay([](auto a, auto b) { return a > b; }));
    const auto table = standingsOf(plan, played.schedule, played.results, played.results.size());
    for (std::size_t i = 0; i < entrants; ++i) CHECK(table[i].entrant == entrants - 1 - i);
  }
}

TEST_CASE("a schedule of 50,000 pairs takes well below 0.3 s in each format", "[unit]") {
  const auto [format, entrants, pairs, rounds] =
      GENERATE(std::tuple{TournamentFormat::kMatch, std::size_t{2}, 50000, 0},
               std::tuple{TournamentFormat::kGauntlet, std::size_t{11}, 5000, 0},
               std::tuple{TournamentFormat::kRoundRobin, std::size_t{101}, 10, 0},
               std::tuple{TournamentFormat::kKnockOut, std::size_t{500}, 100, 0},
               std::tuple{TournamentFormat::kSwiss, std::size_t{1000}, 10, 10},
               std::tuple{TournamentFormat::kSwiss, std::size_t{100}, 20, 50},
               std::tuple{TournamentFormat::kSwiss, std::size_t{40}, 64, 39},
               std::tuple{TournamentFormat::kLadder, std::size_t{100}, 10, 0});
  TournamentPlan plan = planOf(format, entrants, pairs);
  plan.rounds = rounds;
  const Played played = playInOrder(plan, randomPlay(2));
  CHECK(played.results.size() >= 49000);
  const std::clock_t begin = std::clock();
  const Schedule schedule = scheduleOf(plan, played.results);
  const auto table = standingsOf(plan, schedule, played.results, played.results.size());
  const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;  // [s] CPU time
  INFO(nameOf(format) << " of " << entrants << ", " << played.results.size() << " pairs: " << time << " s");
  CHECK(table.size() == entrants);
  CHECK(time < kMostTime);
}
