#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/papers/localization/cleaning_run.hpp"
#include "fulbito/report.hpp"

namespace fulbito::localization {

/// One difference between the robot's knowledge and the truth.
struct WrongCase {
  std::string what;    ///< e.g. "range noise told"
  std::string amount;  ///< e.g. "x 4"
  bool filter_only;    ///< whether the paper's scheme does not use the quantity
  void (*apply)(CleaningTask& task, double amount);
  double value;  ///< argument of `apply`
};

/// All cases: each noise value given to the robot as 1/8 to 8 times the true one, and all of them together;
/// scales of gyro and encoders with larger errors than specified; air that warms after the first fix or is
/// outside 5 to 35 degrees.
std::vector<WrongCase> wrongCases();

/// Runs of one scheme in one case.
struct WrongRuns {
  WrongCase wrong;
  Scheme scheme;
  std::vector<CleaningResult> results;
};

/// Runs every case in the same `rooms` random rooms of the seed, with the filter and the paper's scheme.
/// Empty if `rooms` is 0. Errors: as World::create; kInterrupted.
Result<std::vector<WrongRuns>> runWrongFigures(const std::vector<WrongCase>& cases, std::size_t rooms,
                                               std::uint64_t seed, const SensorSpread& spread, int jobs,
                                               const WorkWatcher& watcher);

/// One row per case and scheme.
ReportTable wrongTable(const std::vector<WrongRuns>& runs);

}  // namespace fulbito::localization
