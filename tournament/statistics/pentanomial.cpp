#include "tournament/statistics/pentanomial.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fulbito {

void PairCounts::add(double points) {
  const double quarters = std::clamp(points, 0.0, 1.0) * static_cast<double>(kPairScores - 1);
  ++counts[static_cast<std::size_t>(std::floor(quarters + 0.5))];
}

std::int64_t PairCounts::pairs() const {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

PairDistribution distributionOf(const PairCounts& counts, double least) {
  PairDistribution distribution{};
  double sum = 0.0;
  for (std::size_t i = 0; i < kPairScores; ++i) {
    distribution[i] = std::max(static_cast<double>(counts.counts[i]), least);
    sum += distribution[i];
  }
  for (double& share : distribution) share /= sum;
  return distribution;
}

PairMoments momentsOf(const PairDistribution& distribution) {
  PairMoments moments{0.0, 0.0};
  for (std::size_t i = 0; i < kPairScores; ++i) moments.mean += distribution[i] * pairScore(i);
  for (std::size_t i = 0; i < kPairScores; ++i) {
    const double off = pairScore(i) - moments.mean;
    moments.variance += distribution[i] * off * off;
  }
  return moments;
}

}  // namespace fulbito
