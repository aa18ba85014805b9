#pragma once

#include "match/drills/drill.hpp"
#include "match/drills/start.hpp"

namespace fulbito {

/// Lower bound [s] of the time in which the tested team's first robot can do the scene's task, by the
/// formulas of time to reach; 0 if there is none. In play that is the first touch,
/// or else the goal with a ball that rests.
double idealTime(const Drill& drill, const DrillScene& scene, const MatchConfig& config);

}  // namespace fulbito
