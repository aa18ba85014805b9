#pragma once

#include "fulbito/detail/math.hpp"

namespace fulbito {

/// Direction [rad] that lies `share` (0 ... 1) of the way from `from` to `to` along the shorter arc.
/// Averaging the plain numbers instead would turn through the far side wherever the two lie across +-pi.
inline double blendAngle(double from, double to, double share) {
  return math::wrapAngle(from + share * math::wrapAngle(to - from));
}

}  // namespace fulbito
