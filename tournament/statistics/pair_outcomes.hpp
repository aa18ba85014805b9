#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tournament/statistics/pentanomial.hpp"

namespace fulbito {

/// The results of a pair's two matches in either order: losses (L), draws (D) and wins (W). Counts by score
/// alone would join kDD and kWL, which differ in their share of draws.
enum class PairOutcome : std::uint8_t { kLL, kLD, kDD, kWL, kWD, kWW };
/// Number of outcomes.
inline constexpr std::size_t kPairOutcomes = 6;

/// Numbers of wins, draws and losses among the two matches of a pair.
struct PairMatches {
  int wins = 0, draws = 0, losses = 0;
};
/// The wins, draws and losses of an outcome.
PairMatches matchesOf(PairOutcome outcome);

/// Counts of pairs by outcome.
struct PairOutcomes {
  std::array<std::int64_t, kPairOutcomes> counts{};  ///< by `PairOutcome`

  /// Adds a pair by the points of its two matches: 0, 1/2 or 1 each, see `PairResult::pointsOfLeg`.
  void add(double first, double second);
  std::int64_t pairs() const;   ///< number of pairs
  std::int64_t wins() const;    ///< matches won
  std::int64_t draws() const;   ///< matches drawn
  std::int64_t losses() const;  ///< matches lost
  /// The same pairs, counted by score.
  PairCounts scores() const;
};

}  // namespace fulbito
