// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// A robot that does not keep its goal holds the ball: it pins it to a wall. It presses the ball, the ball
/// presses a wall, both hardly move and no opponent disputes it, for longer than `pinned_seconds`. A free
/// kick, in its own goal area a penalty (law 8.1). What the law itself forbids, to hide more than 30 % of the
/// ball (2.2.3), takes a hollow body: a rectangle that the ball cannot enter hides nothing of it.
std::optional<Finding> detectHolding(const DetectorInput& input, const PresenceMemory& presence,
                                     FoulMemory& memory);

}  // namespace fulbito
