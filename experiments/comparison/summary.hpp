#pragma once

#include <span>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Fills in `comparison.summary` from its records, one row per block and navigator.
void summarise(Comparison& comparison);

/// A run longer than this multiple of T* counts as hung, since it would dominate any mean.
inline constexpr double kHung = 4.0;
inline constexpr double kNeverHung = 1e9;
/// The T/T* that a failed run counts with in means over all runs.
inline constexpr double kFailureTimeRatio = 8.0;

/// Relative difference of length and time of method a against method b, over the layouts that both solve
/// within `hung` times T*.
struct PairedDifference {
  int pairs = 0;
  Interval length;
  Interval time;
};
PairedDifference compareSafePairs(const Comparison& comparison, std::size_t block, std::size_t a,
                                  std::size_t b, double hung = kNeverHung);
/// The same over the layouts of several blocks with equal navigators.
PairedDifference compareSafePairs(const Comparison& comparison, std::span<const std::size_t> blocks,
                                  std::size_t a, std::size_t b, double hung, std::size_t resamples);

}  // namespace fulbito
