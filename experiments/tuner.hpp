#pragma once

#include <string>

#include "experiments/comparison.hpp"

namespace fulbito {

/// How a method is tuned before it is judged.
struct TuneConfig {
  std::string navigator;  ///< name of the method, with settings to hold fixed if any
  double speed = 1.0;     ///< [m/s]
  int evaluations = 150;  ///< parameter sets tried
  int layouts = 40;  ///< of the suite, with a seed of their own: never those that the method is judged on
};

struct TuneResult {
  std::string navigator;   ///< specification of the best set found
  double objective = 0.0;  ///< its mean T/T* on the training layouts, failures as 8
  double initial = 0.0;    ///< the same of the defaults
  int evaluations = 0;
};

/// Seeded random search over the method's numeric parameters: half of the tries over their whole range, half
/// near the best. Minimises the mean T/T* with failures counted as 8. Errors: kUsage when the method has
/// nothing to tune.
Result<TuneResult> tune(const ComparisonConfig& base, const TuneConfig& config, const Progress& progress);

}  // namespace fulbito
