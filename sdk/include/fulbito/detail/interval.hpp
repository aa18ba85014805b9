#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fulbito {

/// An estimate with its 95 % interval.
struct Interval {
  double value = 0.0;  ///< the estimate
  double low = 0.0;    ///< lower end
  double high = 0.0;   ///< upper end
};

/// Wilson score interval of a rate (E. B. Wilson, 1927); 0 of 0 gives 0 with the interval 0 ... 1.
Interval wilson(int successes, int trials);

/// Mean of values from a distribution of any spread, with Student's t interval. NaN bounds below 2 values.
Interval meanInterval(std::span<const double> values);

/// Mean of shares between 0 and 1, such as the points of pairs of matches. The interval is Wilson's score
/// interval for the effective number of trials: the number at which a rate has the measured variance (Kish's
/// design effect). Unlike Student's t it stays within 0 ... 1. It has a width even if all values are equal,
/// because the variance includes one more value with the variance of a rate. No values: 0 with 0 ... 1.
Interval shareInterval(std::span<const double> shares);

/// Ratio of means `sum(a) / sum(b) - 1` over pairs, with a percentile bootstrap over pairs (`resamples` of
/// `seed`). Empty input gives NaN.
Interval pairedRelativeDifference(std::span<const double> a, std::span<const double> b, std::uint64_t seed,
                                  std::size_t resamples = 10000);

/// Mean; NaN when empty.
double mean(std::span<const double> values);

/// The p-quantile (0 ... 1) by linear interpolation between order statistics; NaN when empty. Reorders
/// `values`.
double quantile(std::vector<double>& values, double p);

}  // namespace fulbito
