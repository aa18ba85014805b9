// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Laws 8.1 and 13: an opponent charges or blocks the keeper in its goal area. The two robots press on each
/// other at a point in the area, with the keeper inside, for `charge_seconds` and with a total of
/// `charge_impulse`. The opponent does not dispute the ball: it has not touched it for `part_seconds`.
std::optional<Finding> detectKeeperCharged(const DetectorInput& input, const TouchMemory& touches,
                                           const PresenceMemory& presence, KeeperMemory& memory);

}  // namespace fulbito
