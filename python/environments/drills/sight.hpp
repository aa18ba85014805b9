#pragma once

#include <span>
#include <string>
#include <vector>

#include "match/drills/drill.hpp"
#include "python/environments/agent_team.hpp"

namespace fulbito {

/// One number of an observation.
struct DrillSightEntry {
  std::string name;
  std::string unit;  ///< empty: a share or a direction
  std::string meaning;
};

/// Numbers lie within -kDrillSightBound ... kDrillSightBound.
inline constexpr float kDrillSightBound = 4.0f;

/// All numbers of an observation, in their order. They are the same for all drills, so that a policy can
/// learn one drill after the other.
const std::vector<DrillSightEntry>& drillSight();

/// What an observation is made from.
struct DrillMoment {
  const AgentSlot& slot;
  int robot = 0;  ///< the agent's
  DrillTask task = DrillTask::kPlay;
  const Exercise& exercise;
  double elapsed = 0.0;  ///< share of the trial's time
};

/// Writes `drillSight().size()` numbers.
void writeDrillSight(const DrillMoment& moment, std::span<float> out);

}  // namespace fulbito
