#include <atomic>
#include <set>

#include "fulbito/statistics.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

SeriesConfig seriesOf(const std::string& a, const std::string& b, int pairs, double half_seconds) {
  SeriesConfig config;
  config.match = shortMatch(a, b, half_seconds);
  config.pairs = pairs;
  config.jobs = 2;
  return config;
}

}  // namespace

TEST_CASE("a team against itself gives exactly zero in every pair", "[unit]") {
  SeriesConfig config = seriesOf("chaser", "chaser", 4, 20.0);
  for (VisionModel& seat : config.match.vision)
    seat.position_noise = 0.002;  // random numbers belong to the seats
  const auto series = playSeries(config);
  REQUIRE(series);
  REQUIRE(series->pairs.size() == 4);
  CHECK_FALSE(series->interrupted);
  std::set<std::uint64_t> hashes;
  for (const PairRecord& pair : series->pairs) {
    CHECK(pair.legs[0].hash == pair.legs[1].hash);
    CHECK(pair.legs[0].score == pair.legs[1].score);
    CHECK(pair.points() == 0.5);
    CHECK(pair.goalsOfA() == pair.goalsOfB());
    hashes.insert(pair.legs[0].hash);
  }
  CHECK(hashes.size() == 4);
  CHECK(series->points_share.value == 0.5);
  CHECK(series->goal_difference.value == 0.0);
  CHECK(series->wins == series->losses);
}

TEST_CASE("the judge hears pairs in their order and ends the series, whatever the jobs", "[unit]") {
  SeriesConfig config = seriesOf("chaser", "idle", 6, 3.0);
  for (const int jobs : {1, 4}) {
    config.jobs = jobs;
    std::vector<std::uint64_t> heard;
    config.judge = [&](const PairRecord& pair) {
      heard.push_back(pair.seed);
      return heard.size() < 3;
    };
    const auto series = playSeries(config);
    REQUIRE(series);
    CHECK_FALSE(series->interrupted);
    REQUIRE(series->pairs.size() == 3);
    for (std::uint64_t i = 0; i < 3; ++i) CHECK(heard[i] == seedOfPair(config.match.seed, i));
    CHECK(heard.size() == 3);
    CHECK(series->wins + series->draws + series->losses == 6);
  }
}

TEST_CASE("the number of jobs changes no result", "[unit]") {
  SeriesConfig config = seriesOf("chaser", "chaser", 3, 3.0);
  for (VisionModel& seat : config.match.vision) seat.latency_ticks = 2;
  config.jobs = 1;
  const auto alone = playSeries(config);
  config.jobs = 4;
  const auto together = playSeries(config);
  REQUIRE(alone);
  REQUIRE(together);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(alone->pairs[i].seed == together->pairs[i].seed);
    for (std::size_t leg = 0; leg < 2; ++leg) {
      CHECK(alone->pairs[i].legs[leg].hash == together->pairs[i].legs[leg].hash);
    }
  }
}

TEST_CASE("the second leg exchanges the seats: points and goals follow the team", "[unit]") {
  const TestEntry still([](const Observation&) { return allWheels({}); });
  SeriesConfig config = seriesOf("chaser", "chaser", 2, 150.0);
  config.match.teams[1] = still.choice();
  const auto series = playSeries(config);
  REQUIRE(series);
  int wins = 0, draws = 0;
  for (const PairRecord& pair : series->pairs) {
    const PerTeam<int>&first = pair.legs[0].score, &second = pair.legs[1].score;
    CHECK(first[0] >= first[1]);  // who stands still scores nothing but by the other's mistake
    CHECK(second[1] >= second[0]);
    CHECK(pair.goalsOfA() == first[0] + second[1]);
    CHECK(pair.goalsOfB() == first[1] + second[0]);
    wins += (first[0] > first[1] ? 1 : 0) + (second[1] > second[0] ? 1 : 0);
    draws += (first[0] == first[1] ? 1 : 0) + (second[1] == second[0] ? 1 : 0);
  }
  CHECK(series->wins == wins);
  CHECK(series->draws == draws);
  CHECK(wins > 0);
  // The same as the statistics of each match alone.
  MatchConfig first = config.match;
  first.seed = series->pairs[0].seed;
  auto match = Match::create(first);
  REQUIRE(match);
  StatisticsObserver watcher;
  match->watch(watcher);
  while (match->step()) {
  }
  int paid = 0, sum = 0;
  for (const TeamId team : kTeams) {
    const int goals = watcher.statistics().teams[indexOf(team)].goals_after_foul;
    CHECK(series->pairs[0].legs[0].goals_after_foul[indexOf(team)] == goals);
  }
  for (const PairRecord& pair : series->pairs) {
    for (const LegRecord& leg : pair.legs) sum += leg.goals_after_foul[0] + leg.goals_after_foul[1];
  }
  paid = series->goals_after_foul_for + series->goals_after_foul_against;
  CHECK(paid == sum);
  CHECK(series->points_share.value == Approx((wins + 0.5 * draws) / 4));
  CHECK(series->goal_difference.value == Approx((series->goals_for - series->goals_against) / 4.0));
}

TEST_CASE("a series that is stopped keeps the pairs that are complete without a gap", "[unit]") {
  SeriesConfig config = seriesOf("chaser", "chaser", 20, 2.0);
  const auto whole = playSeries(config);
  REQUIRE(whole);
  std::size_t told = 0;
  const auto part = playSeries(config, [&](std::size_t done, std::size_t total) {
    CHECK(total == 40);
    CHECK(done >= told);
    told = done;
    return done < 9;
  });
  REQUIRE(part);
  CHECK(part->interrupted);
  CHECK(part->pairs.size() >= 3);
  CHECK(part->pairs.size() <= 5);
  CHECK(part->wins + part->draws + part->losses == 2 * static_cast<int>(part->pairs.size()));
  for (std::size_t i = 0; i < part->pairs.size(); ++i) {
    CHECK(part->pairs[i].legs[1].hash == whole->pairs[i].legs[1].hash);
  }
  const auto none = playSeries(config, [](std::size_t, std::size_t) { return false; });
  REQUIRE(none);
  CHECK(none->pairs.size() <= 1);
}

TEST_CASE("how a team sees goes with it from seat to seat", "[unit]") {
  std::atomic<int> poor{0}, good{0}, wrong{0};
  const auto looking = [](std::atomic<int>& right, std::atomic<int>& odd, bool late) {
    return TestEntry([&right, &odd, late](const Observation& seen) {
      if (seen.tick == (late ? -9 : 0)) ++right;
      if (seen.tick < (late ? -9 : 0)) ++odd;
      return allWheels({});
    });
  };
  SeriesConfig config = seriesOf("chaser", "chaser", 2, 2.0);
  config.match.teams = {looking(poor, wrong, true).choice(), looking(good, wrong, false).choice()};
  config.match.vision[0].latency_ticks = 9;
  REQUIRE(playSeries(config));
  CHECK(poor == 4);
  CHECK(good == 4);
  CHECK(wrong == 0);
}

TEST_CASE("seeds of pairs: the first is the series' own, none twice", "[unit]") {
  CHECK(seedOfPair(77, 0) == 77);
  std::set<std::uint64_t> seeds;
  for (std::uint64_t i = 0; i < 10000; ++i) seeds.insert(seedOfPair(1, i));
  CHECK(seeds.size() == 10000);
  CHECK(seedOfPair(1, 1) != seedOfPair(2, 1));
}

TEST_CASE("what a series cannot play is refused", "[unit]") {
  SeriesConfig config = seriesOf("chaser", "chaser", 0, 1.0);
  CHECK(playSeries(config).error().message == "pairs: 0 is outside 1 ... 100000");
  config.pairs = 1;
  config.jobs = -1;
  CHECK(playSeries(config).error().message == "jobs: -1 is outside 0 ... 1024");
  config.jobs = 2;
  config.match.vision[1].dropout = 2.0;
  CHECK(playSeries(config).error().message == "dropout: 2 is outside 0 ... 0.99");
}

}  // namespace fulbito
