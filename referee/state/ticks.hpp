#pragma once

#include <cmath>

#include "engine/core/base/values.hpp"

namespace fulbito {

/// The whole number of control ticks of `dt` [s] nearest to `seconds`: the referee counts ticks alone.
inline Tick ticksOf(double seconds, double dt) { return static_cast<Tick>(std::floor(seconds / dt + 0.5)); }

}  // namespace fulbito
