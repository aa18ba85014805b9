#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fulbito {

/// An estimate with its 95 % interval.
struct Interval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Wilson score interval of a rate (E. B. Wilson, 1927); 0 of 0 gives 0 with the interval 0 ... 1.
Interval wilson(int successes, int trials);

/// Ratio of means `sum(a) / sum(b) - 1` over pairs, with a percentile bootstrap over pairs (10,000 resamples
/// of `seed`). Empty input gives NaN.
Interval pairedRelativeDifference(std::span<const double> a, std::span<const double> b, std::uint64_t seed);

/// Mean; NaN when empty.
double mean(std::span<const double> values);

/// The p-quantile (0 ... 1) by linear interpolation between order statistics; NaN when empty. Reorders
/// `values`.
double quantile(std::vector<double>& values, double p);

}  // namespace fulbito
