#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fulbito {

/// Exact two-sided p-value of the sign test: the probability that equal sides get wins and losses at least as
/// uneven as these. Ties do not count. 1 if there are neither wins nor losses.
double signTest(std::int64_t wins, std::int64_t losses);

/// p-values adjusted for several tests at once, in the order of `p_values` (S. Holm, 1979). If those at or
/// below alpha are rejected, the probability of any false rejection is at most alpha.
std::vector<double> holm(std::span<const double> p_values);

}  // namespace fulbito
