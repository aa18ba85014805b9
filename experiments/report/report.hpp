#pragma once

#include <string>

#include "experiments/comparison/comparison.hpp"

namespace fulbito {

/// The comparison as one JSON object (docs/results-format.md), pretty-printed with a final newline. Same
/// seed: the same bytes on any number of threads, but for keys that begin with compute_ or wall_.
std::string resultsJson(const Comparison& comparison, double wall_seconds);

/// One trial as a JSON object.
std::string trialJson(const TrialConfig& config, const TrialResult& result);

/// One line a trial, with a header.
std::string trialsCsv(const Comparison& comparison);

/// One line a control tick, with a header.
std::string traceCsv(const TrialResult& result);

/// The tables for people: one a block, then the reproduction.
std::string markdownReport(const Comparison& comparison);

/// Name, version and build of the library as a JSON object.
std::string versionJson();

}  // namespace fulbito
