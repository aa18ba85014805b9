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
  bool whole = false;  ///< whole numbers only: values are rounded before they play
  double start = 0.0;  ///< in the parameter's unit, as `low` and `high`
  double low = 0.0;    ///< least value
  double high = 1.0;   ///< largest value
  double perturbation =
      0.1;            ///< c_end: half the distance of both versions in the last iteration, of the range
  double step = 0.1;  ///< r_end: move of the last iteration over its perturbation, if a version wins all
};

/// A point in the box of all parameters: 0 at `low`, 1 at `high`.
using TunePoint = std::vector<double>;

/// Simultaneous perturbation stochastic approximation (J. C. Spall, "Implementation of the simultaneous
/// perturbation algorithm for stochastic optimization", IEEE Trans. Aerosp. Electron. Syst. 34, 1998). It
/// finds a maximum from noisy comparisons of two points per iteration, however many parameters there are.
struct Spsa {
  std::vector<TunedParameter> parameters;
  int iterations = 100;    ///< the gains reach `perturbation` and `step` in the last one
  std::uint64_t seed = 1;  ///< of the directions
};

/// What an iteration does with a parameter, both in shares of its range.
struct SpsaGain {
  double perturbation = 0.0;  ///< c_k = c / k^0.101: both versions are this far from the present point
  double move = 0.0;          ///< a_k / c_k with a_k = a / (A + k)^0.602: move if a version wins all
};

/// The gains of iteration 1 ... `iterations`. A is a tenth of the iterations, as Spall advises; c and a
/// follow from the values of the last iteration, as in the chess engines' frameworks fishtest and OpenBench.
SpsaGain gainOf(const TunedParameter& parameter, int iteration, int iterations);

/// The two versions that an iteration compares.
struct TunePair {
  TunePoint plus, minus;
};

/// Where the path begins.
TunePoint startOf(const Spsa& spsa);

/// The versions of iteration 1 ...: each parameter goes up in one and down in the other, which way is a fair
/// coin of seed, iteration and parameter. Limits hold.
TunePair versionsAt(const Spsa& spsa, const TunePoint& point, int iteration);

/// The point after an iteration.
/// @param result  points of the plus version less those of the minus version, per match: -1 ... 1
TunePoint nextPoint(const Spsa& spsa, const TunePoint& point, int iteration, double result);

/// The whole path from the results of iterations 1, 2 ...: one point more than results. It depends on nothing
/// else, so a path continues from the results that are kept.
std::vector<TunePoint> pathOf(const Spsa& spsa, std::span<const double> results);

/// Checks numbers, limits and names. Errors: kUsage naming the parameter.
Result<void> validate(const Spsa& spsa);

}  // namespace fulbito
