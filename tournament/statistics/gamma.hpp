#pragma once

#include "engine/core/math/random.hpp"

namespace fulbito {

/// A draw from the gamma distribution with the positive `shape` and scale 1. For a whole shape it is the sum
/// of `shape` independent Exp(1) draws. G. Marsaglia and W. W. Tsang, "A simple method for generating gamma
/// variables" (2000).
double gammaDraw(Rng& rng, double shape);

}  // namespace fulbito
