#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Updates `memory` with the tick's fouls of laws 8.2 and 8.3.
void noteAreaFouls(const DetectorInput& input, const TouchMemory& touches, const PresenceMemory& presence,
                   AreaFoulMemory& memory);

/// Decides on a goal while area fouls are pending. After a foul of the defenders the goal counts; after one
/// of the attackers it becomes a goal kick. If both are pending, `AreaRules::both` chooses the foul that
/// counts.
Finding decideGoal(const DetectorInput& input, const Finding& goal, const AreaFoulMemory& memory);

/// The call that is due, if any: the foul has waited long enough, or the ball has left the area. Of two fouls
/// at the same goal, `AreaRules::both` chooses.
std::optional<Finding> decideAreaFouls(const DetectorInput& input, const AreaFoulMemory& memory);

}  // namespace fulbito
