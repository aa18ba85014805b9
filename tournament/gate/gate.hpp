#pragma once

#include <string>
#include <string_view>

#include "fulbito/statistics.hpp"
#include "tournament/statistics/sprt.hpp"

namespace fulbito {

/// Whether a new team is as strong as its base: pairs of matches until a sequential test has a verdict.
struct GateConfig {
  SeriesConfig series;  ///< the new team is A; `pairs` is the largest number of pairs; `judge` is not used
  SprtBounds bounds;    ///< hypotheses and error rates
};

/// The result of a gate.
struct GateReport {
  GateConfig config;    ///< as given
  SeriesResult series;  ///< the pairs up to the verdict
  Sprt sprt{{}};        ///< the test after the last pair
  double wall = 0.0;    ///< [s] wall time
};

/// Plays until the verdict, or the last pair: then the test is inconclusive. The number of jobs does not
/// affect the result. Errors: kUsage for bounds; as `playSeries`.
Result<GateReport> runGate(const GateConfig& config, const SeriesProgress& progress = {});

/// @{ The report for people, and as one JSON object (docs/results-format.md).
std::string gateText(const GateReport& report);
std::string gateJson(const GateReport& report);
/// @}

}  // namespace fulbito
