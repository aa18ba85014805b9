// Private header of referee: not installed.
#pragma once

#include "referee/detectors.hpp"

namespace fulbito {

/// Laws 13 and 14: the ball is stuck. In a goal area: a goal kick where robots of both teams dispute it, else
/// a penalty (or a goal kick, as the rules say); elsewhere a free ball.
std::optional<Finding> detectStuckBall(const DetectorInput& input, StuckMemory& memory);

}  // namespace fulbito
