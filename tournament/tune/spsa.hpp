#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A parameter that is tuned.
struct TunedParameter {
  std::string name;
  bool whole = false;  ///< only whole numbers: values are rounded before they are used in matches
  double start = 0.0;  ///< in the parameter's unit, as `low` and `high`
  double low = 0.0;    ///< least value
  double high = 1.0;   ///< largest value
  double perturbation =
      0.1;  ///< c_end: half the distance between both versions in the last iteration, as share of the range
  double step = 0.1;  ///< r_end: in the last iteration, move / perturbation if one version wins everything
};

/// A point in the box of all parameters; each coordinate is 0 at `low` and 1 at `high`.
using TunePoint = std::vector<double>;

/// Simultaneous perturbation stochastic approximation (J. C. Spall, "Implementation of the simultaneous
/// perturbation algorithm for stochastic optimization", IEEE Trans. Aerosp. Electron. Syst. 34, 1998). It
/// finds a maximum from noisy comparisons of two points per iteration, for any number of parameters.
struct Spsa {
  std::vector<TunedParameter> parameters;
  int iterations = 100;    ///< number of iterations; gains reach `perturbation` and `step` in the last one
  std::uint64_t seed = 1;  ///< seed of the directions
};

/// The gains of an iteration for one parameter, as shares of its range.
struct SpsaGain {
  double perturbation = 0.0;  ///< c_k = c / k^0.101: distance of both versions from the present point
  double move = 0.0;          ///< a_k / c_k with a_k = a / (A + k)^0.602: move if one version wins everything
};

/// The gains of an iteration, 1 ... `iterations`. A is a tenth of the iterations, as Spall advises. c and a
/// are computed from the values in the last iteration, as in the chess engine frameworks fishtest and
/// OpenBench.
SpsaGain gainOf(const TunedParameter& parameter, int iteration, int iterations);

/// The two versions that an iteration compares.
struct TunePair {
  TunePoint plus, minus;
};

/// The point at the start values of all parameters.
TunePoint startOf(const Spsa& spsa);

/// The two versions of an iteration, from 1. Each parameter is raised in one version and lowered in the
/// other. A fair coin drawn from seed, iteration and parameter decides which is which. Values stay within the
/// limits.
TunePair versionsAt(const Spsa& spsa, const TunePoint& point, int iteration);

/// The point after an iteration. Values stay within the limits.
/// @param result  points of the plus version minus those of the minus version, per match: -1 ... 1
TunePoint nextPoint(const Spsa& spsa, const TunePoint& point, int iteration, double result);

/// All points of the path, from the results of iterations 1, 2, ...: one point more than results. It depends
/// on nothing else, so a tuning can continue from stored results.
std::vector<TunePoint> pathOf(const Spsa& spsa, std::span<const double> results);

/// Checks numbers, limits and names. Errors: kUsage naming the parameter.
Result<void> validate(const Spsa& spsa);

}  // namespace fulbito
