// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// A field player holds the ball by pinning it to a wall: it presses the ball, the ball presses a wall, both
/// hardly move, and no opponent disputes it, for longer than `pinned_seconds`. Gives a free kick, or a
/// penalty in its own goal area (law 8.1). Hiding more than 30 % of the ball (2.2.3) is impossible for a
/// rectangular body.
std::optional<Finding> detectHolding(const DetectorInput& input, const PresenceMemory& presence,
                                     FoulMemory& memory);

}  // namespace fulbito
