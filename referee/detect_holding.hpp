// Private header of referee: not installed.
#pragma once

#include "referee/detectors.hpp"

namespace fulbito {

/// Laws 2.2.3 and 8.1: a robot that does not keep its goal holds the ball: its body covers more than
/// `hidden_share` of it, seen from above, for `hidden_seconds`; or, where the rules call that, it pins the
/// ball: both hardly move, the gap is at most `pinned_gap` and no opponent disputes it, for `pinned_seconds`.
/// A free kick, in its own goal area a penalty.
std::optional<Finding> detectHolding(const DetectorInput& input, const PresenceMemory& presence,
                                     FoulMemory& memory);

}  // namespace fulbito
