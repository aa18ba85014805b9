#include "engine/core/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/random.hpp"

namespace fulbito {
namespace {

constexpr double kZ95 = 1.959963984540054;  // two-sided 95 % point of the normal distribution
constexpr int kResamples = 10000;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Interval wilson(int successes, int trials) {
  if (trials == 0) return {0.0, 0.0, 1.0};
  const double n = trials, p = successes / n, z2 = kZ95 * kZ95;
  const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kZ95 * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n)) / (1 + z2 / n);
  return {p, std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Interval pairedRelativeDifference(std::span<const double> a, std::span<const double> b, std::uint64_t seed) {
  const std::size_t n = std::min(a.size(), b.size());
  if (n == 0) return {kNaN, kNaN, kNaN};
  double sum_a = 0.0, sum_b = 0.0;
  for (std::size_t i = 0; i < n; ++i) sum_a += a[i], sum_b += b[i];
  Rng rng(seed, Stream::kBootstrap);
  std::vector<double> resampled(kResamples);
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
