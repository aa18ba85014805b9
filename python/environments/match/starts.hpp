#pragma once

#include <cstdint>

#include "python/environments/match/task.hpp"

namespace fulbito {

/// All robots and the ball at rest at random places of the field, apart from walls and from each other; every
/// heading is equally likely. The seed determines it. Errors: kUsage if the field has no room.
Result<Placement> randomPlacement(const MatchConfig& match, std::uint64_t seed);

/// Checks keys and limits of `MatchTask::ranges`. Errors: kUsage naming the key, with a suggestion or its
/// range.
Result<void> checkRanges(const MatchTask& task);

/// Draws the models of an episode into `models`, each number within its range. The ranges were checked.
void drawModels(const std::vector<ModelRange>& ranges, std::uint64_t seed, RobotPreset& models);

}  // namespace fulbito
