// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Law 8.1: the keeper keeps the ball. It is in its goal area with the ball there, at most `control_gap` from
/// its body, for `hold_seconds`; breaks up to `release_seconds` do not end the count. An opponent within
/// `dispute_lengths` of the ball challenges: the count begins anew.
std::optional<Finding> detectKeeperHolding(const DetectorInput& input, const PresenceMemory& presence,
                                           KeeperMemory& memory);

}  // namespace fulbito
