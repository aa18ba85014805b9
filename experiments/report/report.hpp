#pragma once

#include <string>

#include "experiments/comparison/comparison.hpp"

namespace fulbito {

/// The comparison as one JSON object (docs/results-format.md), pretty-printed with a final newline. The same
/// seed gives the same bytes on any number of threads, except keys that begin with compute_ or wall_.
std::string resultsJson(const Comparison& comparison, double wall_seconds);

/// One trial as a JSON object.
std::string trialJson(const TrialConfig& config, const TrialResult& result);

/// CSV with one line per trial and a header.
std::string trialsCsv(const Comparison& comparison);

/// CSV with one line per control tick and a header.
std::string traceCsv(const TrialResult& result);

/// Markdown tables for people: one per block, then the reproduction.
std::string markdownReport(const Comparison& comparison);

/// Name, version and build of the library as a JSON object.
std::string versionJson();

}  // namespace fulbito
