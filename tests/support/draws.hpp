#pragma once

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/detail/vec2.hpp"

namespace fulbito::test {

/// A vector of any direction. Draws its length before its direction: in one expression the order would be the
/// compiler's choice, and so would be the scene.
inline Vec2 drawVector(Rng& rng, double least, double most) {
  const double length = rng.uniform(least, most);
  return math::unit(rng.uniform(-math::kPi, math::kPi)) * length;
}

}  // namespace fulbito::test
