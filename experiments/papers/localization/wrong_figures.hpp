#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/papers/localization/cleaning_run.hpp"
#include "fulbito/report.hpp"

namespace fulbito::localization {

/// One way in which what a robot is told differs from what is.
struct WrongCase {
  std::string what;    ///< e.g. "range noise told"
  std::string amount;  ///< e.g. "x 4"
  bool filter_only;    ///< the paper's scheme does not use the figure
  void (*apply)(CleaningTask& task, double amount);
  double value;  ///< for `apply`
};

/// All of them: each figure of noise told 1/8 to 8 times as large as it is, and all together; scales of gyro
/// and encoders off by more than stated; air that warms after the first fix, or is outside 5 to 35 degrees.
std::vector<WrongCase> wrongCases();

/// Runs of one scheme in one case.
struct WrongRuns {
  WrongCase wrong;
  Scheme scheme;
  std::vector<CleaningResult> results;
};

/// Every case in the same `rooms` random rooms of the seed, with filter and paper's scheme; empty without
/// rooms. Errors: as World::create; kInterrupted.
Result<std::vector<WrongRuns>> runWrongFigures(const std::vector<WrongCase>& cases, std::size_t rooms,
                                               std::uint64_t seed, const SensorSpread& spread, int jobs,
                                               const WorkWatcher& watcher);

/// One row per case and scheme.
ReportTable wrongTable(const std::vector<WrongRuns>& runs);

}  // namespace fulbito::localization
