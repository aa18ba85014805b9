#pragma once

#include <string>

#include "experiments/comparison/comparison.hpp"

namespace fulbito {

/// How a method is tuned before it is judged.
struct TuneConfig {
  std::string navigator;  ///< name of the method, with settings to hold fixed if any
  double speed = 1.0;     ///< [m/s]
  int evaluations = 150;  ///< parameter sets tried
  int layouts = 100;  ///< of the suite, with a seed of their own: never those that the method is judged on
};

struct TuneResult {
  std::string navigator;   ///< specification of the best set found
  double objective = 0.0;  ///< its mean T/T* on the layouts of the last round, failures as 8
  double initial = 0.0;    ///< the same of the defaults
  int layouts = 0;         ///< of the last round
  int evaluations = 0;
};

/// How far tries near the best go (one standard deviation), as a share of a parameter's range or of ten times
/// its value, whichever is less: `progress` from 0 to 1 through the last two thirds of the tries.
double tuningSpread(double progress);

/// Seeded random search over the method's numeric parameters: a third of the tries over their whole range,
/// the rest near the best, at first by as much as a value itself and at last by a fiftieth of it, some
/// parameters at a time. Minimises the mean T/T* with failures counted as 8, so that a failure in a hundred
/// weighs as much as 7 % of time. As the best of many tries is partly lucky, the five best and the defaults
/// meet in a last round on three times as many fresh layouts, which decides. Errors: kUsage when the method
/// has nothing to tune.
Result<TuneResult> tune(const ComparisonConfig& base, const TuneConfig& config, const Progress& progress);

}  // namespace fulbito
