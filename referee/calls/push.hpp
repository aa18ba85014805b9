// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Law 8.1: pushing an opponent away from the ball. The two press on each other for `push_seconds` with a
/// total of `push_impulse`, and the pushed robot moves away from the pusher at `push_speed` or more. Both
/// centres are farther than `push_distance` from the ball, and neither robot touched it for `part_seconds`.
std::optional<Finding> detectPush(const DetectorInput& input, const TouchMemory& touches, FoulMemory& memory);

}  // namespace fulbito
