#pragma once

#include "experiments/papers/hybrid/hybrid_runs.hpp"

namespace fulbito::hybrid {

/// Figures, tables, chart and notes of the runs.
void addResults(const HybridRuns& runs, ExperimentReport& report);

/// The row whose two ways show Fig. 8 best: both arrive, and the ratio of their lengths is the median. The
/// first one if no pair arrives.
std::uint64_t typicalRow(const HybridRuns& runs);

}  // namespace fulbito::hybrid
