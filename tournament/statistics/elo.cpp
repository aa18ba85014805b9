#include "tournament/statistics/elo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "tournament/statistics/normal.hpp"

namespace fulbito {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kZ95 = 1.959963984540054;  // two-sided 95 % point of the normal distribution

/// Mean and variance of the counts, without a minimum for scores that never occurred.
PairMoments measured(const PairCounts& counts) { return momentsOf(distributionOf(counts, 0.0)); }

Interval normalizedElo(const PairMoments& moments, double pairs) {
  if (moments.variance <= 0.0) return {moments.mean > 0.5 ? kInfinity : -kInfinity, -kInfinity, kInfinity};
  // The mean of n pairs has the standard deviation sigma / sqrt(n). Divided by a match's sigma * sqrt(2) it
  // is 1 / sqrt(2 n).
  const double half = kZ95 / std::sqrt(2.0 * pairs);
  const double strength = normalizedStrength(moments);
  return {kEloPerStrength * strength, kEloPerStrength * (strength - half),
          kEloPerStrength * (strength + half)};
}

}  // namespace

double eloOf(double score) {
  if (score <= 0.0) return -kInfinity;
  if (score >= 1.0) return kInfinity;
  return -400.0 * math::log(1.0 / score - 1.0) / math::log(10.0);
}

double scoreOf(double elo) { return 1.0 / (1.0 + math::pow(10.0, -elo / 400.0)); }

double normalizedStrength(const PairMoments& moments) {
  return (moments.mean - 0.5) / std::sqrt(2.0 * moments.variance);
}

EloEstimate estimateElo(const PairCounts& counts) {
  EloEstimate estimate{{0.0, -kInfinity, kInfinity}, {0.0, -kInfinity, kInfinity}, 0.5};
  const double pairs = static_cast<double>(counts.pairs());
  if (pairs == 0.0) return estimate;
  const PairMoments moments = measured(counts);
  const double error = std::sqrt(moments.variance / pairs);
  estimate.elo = {eloOf(moments.mean), eloOf(moments.mean - kZ95 * error),
                  eloOf(moments.mean + kZ95 * error)};
  if (moments.variance == 0.0 && moments.mean == 0.5) return {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.5};
  estimate.normalized_elo = normalizedElo(moments, pairs);
  estimate.superiority = error > 0.0 ? normalShareBelow((moments.mean - 0.5) / error) : (moments.mean > 0.5);
  return estimate;
}

}  // namespace fulbito
