// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Laws 13 and 14: the ball is stuck. In a goal area: a goal kick where robots of both teams dispute it, else
/// what `StuckRules::undisputed` says; elsewhere a free ball. `keepers` of this tick: the count stands while
/// a keeper has undisputed control.
std::optional<Finding> detectStuckBall(const DetectorInput& input, const KeeperMemory& keepers,
                                       StuckMemory& memory);

}  // namespace fulbito
