// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Law 8.1: an opponent is pushed, away from the ball. The two press on each other, the one pushed moves away
/// from the pusher at `push_speed` or more, for `push_seconds` with `push_impulse` in all, both centres are
/// farther than `push_distance` from the ball, and neither touched it for `part_seconds`.
std::optional<Finding> detectPush(const DetectorInput& input, const TouchMemory& touches, FoulMemory& memory);

}  // namespace fulbito
