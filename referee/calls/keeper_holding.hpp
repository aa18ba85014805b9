// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Law 8.1: the keeper holds the ball. Both are in its goal area, at most `control_gap` apart, for
/// `hold_seconds`; breaks of up to `release_seconds` do not end the count. An opponent within
/// `dispute_lengths` of the ball restarts the count.
std::optional<Finding> detectKeeperHolding(const DetectorInput& input, const PresenceMemory& presence,
                                           KeeperMemory& memory);

}  // namespace fulbito
