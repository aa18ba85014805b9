// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Laws 8.1 and 13: an opponent charges or blocks the keeper in its goal area. Robot presses on robot (with
/// the ball between them the two do not touch) at a point in the area, the keeper being inside, for
/// `charge_seconds` with `charge_impulse` in all, by an opponent that does not dispute the ball: it has not
/// touched it for `part_seconds`.
std::optional<Finding> detectKeeperCharged(const DetectorInput& input, const TouchMemory& touches,
                                           const PresenceMemory& presence, KeeperMemory& memory);

}  // namespace fulbito
