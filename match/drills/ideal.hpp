#pragma once

#include "match/drills/drill.hpp"
#include "match/drills/start.hpp"

namespace fulbito {

/// Least time [s] in which the tested team's first robot could do what the scene asks for, as far as the
/// formulas of time to reach go; 0 where there is none.
double idealTime(const Drill& drill, const DrillScene& scene, const MatchConfig& config);

}  // namespace fulbito
