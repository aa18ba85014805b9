#include "tests/unit/tournament/formats/played.hpp"

#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito::test {
namespace {

bool sameFixture(const Fixture& a, const Fixture& b) {
  return a.a == b.a && a.b == b.b && a.round == b.round && a.start == b.start;
}

void setWinner(MatchResult& match) {
  if (match.score[0] != match.score[1]) {
    match.winner = match.score[0] > match.score[1] ? TeamId::kBlue : TeamId::kYellow;
  }
}

std::vector<std::size_t> missingOf(const Played& played) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < played.schedule.fixtures.size(); ++i) {
    if (i >= played.results.size() || !played.results[i]) missing.push_back(i);
  }
  return missing;
}

void record(Played& played, std::size_t fixture, const Play& play) {
  if (played.results.size() <= fixture) played.results.resize(fixture + 1);
  played.results[fixture] = play(played.schedule.fixtures[fixture]);
}

void grow(Played& played, const TournamentPlan& plan) {
  Schedule next = scheduleOf(plan, played.results);
  const auto& before = played.schedule.fixtures;
  REQUIRE(next.fixtures.size() >= before.size());
  REQUIRE(std::equal(before.begin(), before.end(), next.fixtures.begin(), sameFixture));
  REQUIRE(static_cast<std::int64_t>(next.fixtures.size()) <= mostFixtures(plan));
  if (played.schedule.complete) REQUIRE(sameSchedule(next, played.schedule));
  played.schedule = std::move(next);
}

}  // namespace

TournamentPlan planOf(TournamentFormat format, std::size_t entrants, int pairs) {
  TournamentPlan plan;
  plan.format = format;
  plan.pairs = pairs;
  plan.entrants.resize(entrants);
  for (std::size_t i = 0; i < entrants; ++i) plan.entrants[i].name = "e" + std::to_string(i);
  return plan;
}

PairResult pairOf(int a0, int b0, int a1, int b1) {
  PairResult pair;
  pair.legs[0].score = {a0, b0};
  pair.legs[1].score = {b1, a1};
  for (MatchResult& match : pair.legs) setWinner(match);
  return pair;
}

Play randomPlay(std::uint64_t seed) {
  return [seed](const Fixture& fixture) {
    const auto [low, high] = std::minmax(fixture.a, fixture.b);
    Rng rng(seed, kTestStream, (low * 1000 + high) * 1000 + fixture.start);
    const std::uint32_t most = 1 + static_cast<std::uint32_t>(seed % 4);  // 1: goalless draws only
    PairResult pair;
    for (MatchResult& match : pair.legs) {
      match.score = {static_cast<int>(rng.below(most)), static_cast<int>(rng.below(most))};
      setWinner(match);
      if (!match.winner && rng.below(8) == 0) match.winner = TeamId::kYellow;
    }
    return pair;
  };
}

Play orderedPlay(std::function<bool(std::size_t, std::size_t)> before) {
  return [before = std::move(before)](const Fixture& fixture) {
    return before(fixture.a, fixture.b) ? pairOf(1, 0, 1, 0) : pairOf(0, 1, 0, 1);
  };
}

Played playInOrder(const TournamentPlan& plan, const Play& play) {
  Played played;
  for (grow(played, plan);; grow(played, plan)) {
    const auto missing = missingOf(played);
    if (missing.empty()) break;
    for (const std::size_t fixture : missing) record(played, fixture, play);
  }
  REQUIRE(played.schedule.complete);
  return played;
}

Played playInDisorder(const TournamentPlan& plan, const Play& play, Rng& rng) {
  Played played;
  for (grow(played, plan);; grow(played, plan)) {
    const auto missing = missingOf(played);
    if (missing.empty()) break;
    record(played, missing[rng.below(static_cast<std::uint32_t>(missing.size()))], play);
    for (const std::size_t fixture : missing) {
      if (rng.below(2) == 0) record(played, fixture, play);
    }
  }
  REQUIRE(played.schedule.complete);
  return played;
}

std::string orderOf(const std::vector<Standing>& table) {
  std::string order;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (i > 0) order += " ";
    if (i > 0 && table[i].rank == table[i - 1].rank) order += "=";
    order += std::to_string(table[i].entrant);
  }
  return order;
}

bool sameSchedule(const Schedule& a, const Schedule& b) {
  return a.complete == b.complete && a.fixtures.size() == b.fixtures.size() &&
         std::equal(a.fixtures.begin(), a.fixtures.end(), b.fixtures.begin(), sameFixture);
}

}  // namespace fulbito::test
