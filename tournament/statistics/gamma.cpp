#include "tournament/statistics/gamma.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

/// A draw for shapes of at least 1.
double largeGamma(Rng& rng, double shape) {
  const double d = shape - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
  while (true) {
    const double x = rng.normal(), root = 1.0 + c * x;
    if (root <= 0.0) continue;
    const double v = root * root * root, u = 1.0 - rng.uniform(), squared = x * x;
    if (u < 1.0 - 0.0331 * squared * squared) return d * v;
    if (math::log(u) < 0.5 * squared + d * (1.0 - v + math::log(v))) return d * v;
  }
}

}  // namespace

double gammaDraw(Rng& rng, double shape) {
  if (shape == 1.0) return -math::log(1.0 - rng.uniform());
  if (shape > 1.0) return largeGamma(rng, shape);
  return largeGamma(rng, shape + 1.0) * math::pow(1.0 - rng.uniform(), 1.0 / shape);
}

}  // namespace fulbito
