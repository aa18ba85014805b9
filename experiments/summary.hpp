#pragma once

#include "experiments/comparison.hpp"

namespace fulbito {

/// Fills in `comparison.summary` from its records, one row a block and navigator.
void summarise(Comparison& comparison);

/// Relative difference "a against b" of length and time over the layouts that both solved within `hung` times
/// T*.
struct PairedDifference {
  int pairs = 0;
  Interval length;
  Interval time;
};
PairedDifference compareSafePairs(const Comparison& comparison, std::size_t block, std::size_t a,
                                  std::size_t b, double hung = 1e9);

}  // namespace fulbito
