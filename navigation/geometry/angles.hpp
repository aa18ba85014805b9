#pragma once

#include "fulbito/detail/math.hpp"

namespace fulbito {

/// Direction [rad] at the share `share` (0 ... 1) of the turn from `from` to `to` along the shorter arc. The
/// mean of the plain numbers would be wrong if the two lie on different sides of +-pi.
inline double blendAngle(double from, double to, double share) {
  return math::wrapAngle(from + share * math::wrapAngle(to - from));
}

}  // namespace fulbito
