#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/interval.hpp"

namespace fulbito {
namespace {

constexpr double kZ95 = 1.959963984540054;  // two-sided 95 % point of the normal distribution
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Wilson's score interval for a rate `p` in `n` trials. `n` may be a fraction.
Interval scoreInterval(double p, double n) {
  const double z2 = kZ95 * kZ95;
  const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kZ95 * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n)) / (1 + z2 / n);
  return {p, std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

/// Two-sided 95 % point of Student's t: exact up to 9 degrees of freedom, then by the Cornish-Fisher
/// expansion (Abramowitz & Stegun 26.7.5), correct to 4 digits.
double studentT95(std::size_t freedom) {
  constexpr double kExact[] = {12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622};
  if (freedom <= std::size(kExact)) return kExact[freedom - 1];
  const double z = kZ95, z3 = z * z * z, z5 = z3 * z * z, n = static_cast<double>(freedom);
  const double z7 = z5 * z * z, z9 = z7 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n) +
         (79 * z9 + 776 * z7 + 1482 * z5 - 1920 * z3 - 945 * z) / (92160 * n * n * n * n);
}

double squaredDeviations(std::span<const double> values, double about) {
  double sum = 0.0;
  for (double v : values) sum += (v - about) * (v - about);
  return sum;
}

}  // namespace

Interval wilson(int successes, int trials) {
  if (trials == 0) return {0.0, 0.0, 1.0};
  return scoreInterval(static_cast<double>(successes) / trials, trials);
}

Interval meanInterval(std::span<const double> values) {
  const double centre = mean(values);
  if (values.size() < 2) return {centre, kNaN, kNaN};
  const double n = static_cast<double>(values.size());
  const double error = std::sqrt(squaredDeviations(values, centre) / (n - 1) / n);
  const double half = studentT95(values.size() - 1) * error;
  return {centre, centre - half, centre + half};
}

Interval shareInterval(std::span<const double> shares) {
  if (shares.empty()) return {0.0, 0.0, 1.0};
  const double n = static_cast<double>(shares.size()), p = mean(shares);
  const double most = p * (1 - p);  // largest variance of shares with this mean: each is 0 or 1
  if (!(most > 0.0)) return scoreInterval(p, n);
  const double variance = (squaredDeviations(shares, p) + most) / n;
  return scoreInterval(p, n * most / variance);
}

Interval pairedRelativeDifference(std::span<const double> a, std::span<const double> b, std::uint64_t seed,
                                  std::size_t resamples) {
  const std::size_t n = std::min(a.size(), b.size());
  if (n == 0) return {kNaN, kNaN, kNaN};
  double sum_a = 0.0, sum_b = 0.0;
  for (std::size_t i = 0; i < n; ++i) sum_a += a[i], sum_b += b[i];
  Rng rng(seed, Stream::kBootstrap);
  std::vector<double> resampled(std::max<std::size_t>(resamples, 1));
  for (double& ratio : resampled) {
    double ra = 0.0, rb = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t pick = rng.below(static_cast<std::uint32_t>(n));
      ra += a[pick];
      rb += b[pick];
    }
    ratio = ra / rb - 1.0;
  }
  const double low = quantile(resampled, 0.025), high = quantile(resampled, 0.975);
  return {sum_a / sum_b - 1.0, low, high};
}

double mean(std::span<const double> values) {
  if (values.empty()) return kNaN;
  double sum = 0.0;
  for (double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double quantile(std::vector<double>& values, double p) {
  if (values.empty()) return kNaN;
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace fulbito
