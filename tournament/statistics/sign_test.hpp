#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fulbito {

/// Exact two-sided p-value of the sign test: the probability, for equal sides, of wins and losses at least as
/// uneven as these. Ties do not count. 1 without a win and a loss.
double signTest(std::int64_t wins, std::int64_t losses);

/// p-values of several tests at once (S. Holm, 1979): to reject those at or below alpha gives at least one
/// false rejection with probability alpha at most. In the order of `p_values`.
std::vector<double> holm(std::span<const double> p_values);

}  // namespace fulbito
