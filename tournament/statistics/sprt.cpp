#include "tournament/statistics/sprt.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tournament/statistics/elo.hpp"

namespace fulbito {
namespace {

constexpr int kMostRounds = 60;
constexpr double kSettled = 1e-9;  // largest change of a probability that ends the iteration

/// The x with sum(p[i] a[i] / (1 + x a[i])) = 0. The sum decreases with x between its poles at -1 / max(a)
/// and -1 / min(a). `a` must have values of both signs.
double multiplierOf(const PairDistribution& p, const PairDistribution& a) {
  const auto [least, most] = std::minmax_element(a.begin(), a.end());
  double low = -1.0 / *most, high = -1.0 / *least;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    double sum = 0.0;
    for (std::size_t k = 0; k < kPairScores; ++k) sum += p[k] * a[k] / (1.0 + middle * a[k]);
    (sum > 0.0 ? low : high) = middle;
  }
  return low + (high - low) / 2;
}

/// The constraint "mean - 1/2 = s sigma", linearised about a distribution with these moments. Returns the
/// values whose mean must be 0. The derivative of sigma by p[i] is ((a[i] - mean)^2 - mean^2) / (2 sigma).
/// The constant part makes the constraint exact for the distribution itself.
PairDistribution constraintAbout(const PairMoments& moments, double s) {
  const double sigma = std::sqrt(moments.variance);
  PairDistribution values{};
  for (std::size_t i = 0; i < kPairScores; ++i) {
    const double off = (pairScore(i) - moments.mean) / sigma;
    values[i] = pairScore(i) - 0.5 - s * sigma * (1.0 + off * off) / 2.0;
  }
  return values;
}

bool haveBothSigns(const PairDistribution& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *least < 0.0 && *most > 0.0;
}

double largestChange(const PairDistribution& a, const PairDistribution& b) {
  double change = 0.0;
  for (std::size_t i = 0; i < kPairScores; ++i) change = std::max(change, std::abs(a[i] - b[i]));
  return change;
}

}  // namespace

double SprtBounds::lower() const { return math::log(beta / (1.0 - alpha)); }
double SprtBounds::upper() const { return math::log((1.0 - beta) / alpha); }

PairDistribution likeliestDistribution(const PairDistribution& frequencies, double strength) {
  // The standard deviation of a match's score is sqrt(2) times that of a pair's score.
  const double s = strength * std::sqrt(2.0);
  PairDistribution likeliest;
  likeliest.fill(1.0 / kPairScores);
  for (int round = 0; round < kMostRounds; ++round) {
    const PairDistribution values = constraintAbout(momentsOf(likeliest), s);
    if (!haveBothSigns(values)) {
      // The distribution is too far off for a linear constraint: starts again from one with more spread.
      for (double& share : likeliest) share = (share + 1.0 / kPairScores) / 2;
      continue;
    }
    const double x = multiplierOf(frequencies, values);
    const PairDistribution before = likeliest;
    for (std::size_t i = 0; i < kPairScores; ++i) likeliest[i] = frequencies[i] / (1.0 + x * values[i]);
    if (largestChange(likeliest, before) < kSettled) break;
  }
  return likeliest;
}

double logLikelihoodRatio(const PairCounts& counts, const SprtBounds& bounds) {
  const double pairs = static_cast<double>(counts.pairs());
  if (pairs == 0.0) return 0.0;
  const PairDistribution frequencies = distributionOf(counts);
  const PairDistribution weak = likeliestDistribution(frequencies, bounds.weak / kEloPerStrength);
  const PairDistribution strong = likeliestDistribution(frequencies, bounds.strong / kEloPerStrength);
  double ratio = 0.0;
  for (std::size_t i = 0; i < kPairScores; ++i) ratio += frequencies[i] * math::log(strong[i] / weak[i]);
  return pairs * ratio;
}

void Sprt::add(double points) {
  if (verdict_ != SprtVerdict::kInconclusive) return;
  counts_.add(points);
  ratio_ = logLikelihoodRatio(counts_, bounds_);
  if (ratio_ >= bounds_.upper()) verdict_ = SprtVerdict::kPass;
  if (ratio_ <= bounds_.lower()) verdict_ = SprtVerdict::kFail;
}

std::string_view nameOf(SprtVerdict verdict) {
  switch (verdict) {
    case SprtVerdict::kPass:
      return "pass";
    case SprtVerdict::kFail:
      return "fail";
    case SprtVerdict::kInconclusive:
      break;
  }
  return "inconclusive";
}

}  // namespace fulbito
