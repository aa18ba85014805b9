#pragma once

#include <cmath>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The number of control ticks of `dt` [s] nearest to `seconds`. The referee counts only ticks.
inline Tick ticksOf(double seconds, double dt) { return static_cast<Tick>(std::floor(seconds / dt + 0.5)); }

}  // namespace fulbito
