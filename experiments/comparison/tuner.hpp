#pragma once

#include <string>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Settings of a tuning run.
struct TuneConfig {
  std::string navigator;  ///< name of the method, optionally with fixed settings
  double speed = 1.0;     ///< [m/s]
  int evaluations = 150;  ///< number of parameter sets to try
  int layouts = 100;      ///< number of training layouts of the suite, with their own seed
};

struct TuneResult {
  std::string navigator;   ///< specification of the best set found
  double objective = 0.0;  ///< its mean T/T* on the layouts of the last round, failures as 8
  double initial = 0.0;    ///< the same for the defaults
  int layouts = 0;         ///< number of layouts in the last round
  int evaluations = 0;
};

/// Standard deviation of tries near the best, as a share of the smaller of a parameter's range and ten times
/// its value. `progress` goes from 0 to 1 during the last two thirds of the tries.
double tuningSpread(double progress);

/// Seeded random search over the method's numeric parameters. A third of the tries cover the whole range. The
/// others change some parameters of the best set, at first by up to their value and finally by a fiftieth of
/// it. Minimises the mean T/T*, where a failure counts as 8: one failure in a hundred weighs as much as 7 %
/// of time. Since the best of many tries is partly luck, the five best and the defaults compete in a last
/// round on three times as many new layouts. Errors: kUsage if the method has no numeric parameter.
Result<TuneResult> tune(const ComparisonConfig& base, const TuneConfig& config, const Progress& progress);

}  // namespace fulbito
