#pragma once

#include <string>

namespace fulbito {

/// A scale with round steps: 1, 2 or 5 times a power of ten.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  double step = 0.2;
  int decimals = 1;  ///< decimals that the steps need

  int steps() const;
  /// `value` with `decimals` + `more` decimals.
  std::string text(double value, int more = 0) const;
};

/// An axis with 4 to 10 steps around low <= 0 <= high. Both must be finite; they are limited to +-1e9. [0, 1]
/// if both are 0.
Axis niceAxis(double low, double high);

}  // namespace fulbito
