#pragma once

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// A round region that a robot's centre must not enter.
struct Circle {
  Vec2 centre;
  double radius = 0.0;  ///< [m]
};

}  // namespace fulbito
