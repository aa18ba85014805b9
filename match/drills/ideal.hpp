#pragma once

#include "match/drills/drill.hpp"
#include "match/drills/start.hpp"

namespace fulbito {

/// Whether a least time is known for the start: for poses and turns, and in play for the first touch, or else
/// for a goal with a ball that rests.
bool hasLeastTime(const Drill& drill, const DrillStart& start);

/// That time: a lower bound [s] of the time in which the tested team can do the scene's task, by the formulas
/// of time to reach; 0 if there is none.
double idealTime(const Drill& drill, const DrillScene& scene, const MatchConfig& config);

}  // namespace fulbito
