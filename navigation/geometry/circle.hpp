#pragma once

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// A round region that a robot's centre shall keep out of.
struct Circle {
  Vec2 centre;
  double radius = 0.0;  ///< [m]
};

}  // namespace fulbito
