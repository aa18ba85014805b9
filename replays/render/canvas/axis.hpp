#pragma once

#include <string>

namespace fulbito {

/// A scale with round steps: 1, 2 or 5 times a power of ten.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  double step = 0.2;
  int decimals = 1;  ///< that the steps need

  int steps() const;
  /// `value` with `decimals` + `more` decimals.
  std::string text(double value, int more = 0) const;
};

/// The axis with 4 to 10 steps around low <= 0 <= high, both finite, cut at +-1e9; [0, 1] when both are 0.
Axis niceAxis(double low, double high);

}  // namespace fulbito
