#pragma once

#include <string>
#include <vector>

#include "tests/support/test_teams.hpp"
#include "tournament/report/table.hpp"

namespace fulbito::test {

/// A plan with entrants of these names. Its matches are never played.
inline TournamentPlan planOf(TournamentFormat format, const std::vector<std::string>& names, int pairs = 1) {
  TournamentPlan plan;
  plan.name = "cup";
  plan.format = format;
  plan.match = shortMatch("idle", "idle", 30.0);
  plan.pairs = pairs;
  for (const std::string& name : names) plan.entrants.push_back({name, *parseTeam("idle"), {}});
  return plan;
}

/// The result of a match that ended `blue`:`yellow`.
inline MatchResult resultOf(int blue, int yellow) {
  MatchResult result;
  result.score = {blue, yellow};
  if (blue != yellow) result.winner = blue > yellow ? TeamId::kBlue : TeamId::kYellow;
  result.ticks = 3600;
  result.hash = 0xabcULL + static_cast<std::uint64_t>(16 * blue + yellow);
  return result;
}

/// A pair in which A scored `first`[0] goals in the first match and `second`[0] in the second.
inline PairResult pairOf(PerTeam<int> first, PerTeam<int> second, std::uint64_t seed = 1) {
  return {seed, {resultOf(first[0], first[1]), resultOf(second[1], second[0])}};
}

inline MatchId idOfNumber(std::size_t fixture, std::size_t leg) { return {{0xf00d, 2 * fixture + leg}}; }

/// Builds a state from fixtures and results.
class StateMaker {
 public:
  explicit StateMaker(TournamentPlan plan) {
    state_.plan = std::move(plan);
    state_.schedule.complete = true;
  }
  /// Adds a fixture, and its result if one is given.
  StateMaker& add(Fixture fixture, std::optional<PairResult> result) {
    state_.schedule.fixtures.push_back(fixture);
    state_.ids.push_back({idOfNumber(state_.ids.size(), 0), idOfNumber(state_.ids.size(), 1)});
    state_.results.push_back(std::move(result));
    state_.counted = state_.results.size();
    return *this;
  }
  /// Adds a sequential test, which gets the results before the first gap.
  StateMaker& test(const SprtBounds& bounds) {
    state_.plan.sprt = bounds;
    state_.sprt.emplace(bounds);
    for (std::size_t i = 0; i < state_.results.size(); ++i) {
      if (!state_.results[i] || state_.sprt->verdict() != SprtVerdict::kInconclusive) break;
      state_.sprt->add(state_.results[i]->points());
      if (state_.sprt->verdict() != SprtVerdict::kInconclusive) state_.counted = i + 1;
    }
    return *this;
  }
  const TournamentState& state() const { return state_; }
  TournamentState& state() { return state_; }

 private:
  TournamentState state_;
};

/// A made-up, deterministic result: entrants with a small index are stronger.
inline PairResult madeUpPair(const Fixture& fixture, std::uint64_t seed) {
  const auto goals = [&](std::size_t entrant, std::uint64_t salt) {
    const std::uint64_t mixed = (seed * 2654435761u + entrant * 40503u + salt * 97u) >> 7u;
    return static_cast<int>(mixed % 5u) + (entrant < 3 ? 2 - static_cast<int>(entrant) : 0);
  };
  return pairOf({goals(fixture.a, 1), goals(fixture.b, 2)}, {goals(fixture.a, 3), goals(fixture.b, 4)}, seed);
}

/// A round robin with `pairs` pairs per meeting and made-up results.
inline StateMaker madeUpRoundRobin(const std::vector<std::string>& names, int pairs = 1) {
  StateMaker maker(planOf(TournamentFormat::kRoundRobin, names, pairs));
  std::uint64_t seed = 1;
  for (int p = 0; p < pairs; ++p) {
    for (std::size_t a = 0; a < names.size(); ++a) {
      for (std::size_t b = a + 1; b < names.size(); ++b) {
        const Fixture fixture{a, b, p, static_cast<std::size_t>(p)};
        maker.add(fixture, madeUpPair(fixture, ++seed));
      }
    }
  }
  return maker;
}

inline std::vector<std::string> teamNames(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back("team" + std::to_string(i));
  return names;
}

}  // namespace fulbito::test
