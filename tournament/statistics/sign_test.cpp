#include "tournament/statistics/sign_test.hpp"

#include <algorithm>
#include <numeric>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

/// log((n choose k) / 2^n): log of the probability of k wins in n matches between equal sides.
double logChance(std::int64_t n, std::int64_t k) {
  double sum = -static_cast<double>(n) * math::log(2.0);
  for (std::int64_t i = 0; i < k; ++i) {
    sum += math::log(static_cast<double>(n - i) / static_cast<double>(i + 1));
  }
  return sum;
}

/// Probability of 0 ... k wins in n matches, divided by that of exactly k wins.
double tailOver(std::int64_t n, std::int64_t k) {
  double sum = 1.0, term = 1.0;
  for (std::int64_t i = k; i > 0 && term > 1e-17 * sum; --i) {
    term *= static_cast<double>(i) / static_cast<double>(n - i + 1);
    sum += term;
  }
  return sum;
}

}  // namespace

double signTest(std::int64_t wins, std::int64_t losses) {
  const std::int64_t n = wins + losses, fewer = std::min(wins, losses);
  return std::min(1.0, 2.0 * math::exp(logChance(n, fewer)) * tailOver(n, fewer));
}

std::vector<double> holm(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> corrected(p_values.size());
  double most = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double tests_left = static_cast<double>(order.size() - i);
    most = std::max(most, std::min(1.0, tests_left * p_values[order[i]]));
    corrected[order[i]] = most;
  }
  return corrected;
}

}  // namespace fulbito
