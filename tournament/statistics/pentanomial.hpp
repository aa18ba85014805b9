#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fulbito {

/// The score of a pair of matches: 0, 1/4, 1/2, 3/4 or 1 of its two points. The two matches of a pair have
/// the same start and seed with exchanged sides, so their results depend on each other and only pairs count.
inline constexpr std::size_t kPairScores = 5;
/// The i-th of them.
constexpr double pairScore(std::size_t i) { return 0.25 * static_cast<double>(i); }

/// Counts of pairs by score: two losses; a loss and a draw; two draws or a win and a loss; a win and a draw;
/// two wins.
struct PairCounts {
  std::array<std::int64_t, kPairScores> counts{};

  /// Adds a pair by its points, 0 ... 1 in quarters, see PairRecord::points.
  void add(double points);
  /// Number of pairs.
  std::int64_t pairs() const;
};

/// A distribution of pair scores: its probabilities add up to 1.
using PairDistribution = std::array<double, kPairScores>;

/// Frequencies of the counts. Each count is at least `least`, so that scores that never occurred keep a small
/// probability and logarithms stay finite. Without a pair the distribution is even.
PairDistribution distributionOf(const PairCounts& counts, double least = 1e-3);

/// Mean and variance of a pair's score.
struct PairMoments {
  double mean = 0.5;
  double variance = 0.0;
};
PairMoments momentsOf(const PairDistribution& distribution);

}  // namespace fulbito
