#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fulbito {

/// Number of possible scores of a pair: 0, 1/4, 1/2, 3/4 or 1 of its two points. Both matches of a pair have
/// the same start and seed with exchanged sides. So their results depend on each other, and statistics count
/// pairs.
inline constexpr std::size_t kPairScores = 5;
/// The score with index `i`.
constexpr double pairScore(std::size_t i) { return 0.25 * static_cast<double>(i); }

/// Counts of pairs by score, in order: two losses; a loss and a draw; two draws or a win and a loss; a win
/// and a draw; two wins.
struct PairCounts {
  std::array<std::int64_t, kPairScores> counts{};

  /// Adds a pair by its points, 0 ... 1 in quarters, see `PairResult::points`.
  void add(double points);
  /// Number of pairs.
  std::int64_t pairs() const;
};

/// Probabilities of the pair scores; they add up to 1.
using PairDistribution = std::array<double, kPairScores>;

/// Relative frequencies of the counts. Each count is at least `least`, so that scores that never occurred
/// keep a small probability and logarithms stay finite. Without pairs the distribution is uniform.
PairDistribution distributionOf(const PairCounts& counts, double least = 1e-3);

/// Mean and variance of a pair's score.
struct PairMoments {
  double mean = 0.5;
  double variance = 0.0;
};
PairMoments momentsOf(const PairDistribution& distribution);

}  // namespace fulbito
