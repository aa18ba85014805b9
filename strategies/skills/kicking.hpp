#pragma once

#include <cstddef>

#include "fulbito/strategy.hpp"

namespace fulbito {

/// When a robot that was placed for an own kick-off or penalty still drives straight on.
struct KickLimits {
  double longest = 0.6;    ///< [s] after the start of play
  double straight = 0.15;  ///< [rad] between its heading and the way to the ball
};

/// Whether own robot `i` takes a kick-off or penalty for which it was placed. It then drives straight on
/// until the ball has left.
bool isKicking(const Observation& now, std::size_t i, const KickLimits& limits = {});

}  // namespace fulbito
