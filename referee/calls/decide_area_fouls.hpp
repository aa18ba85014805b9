// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Takes in the tick's fouls of laws 8.2 and 8.3.
void noteAreaFouls(const DetectorInput& input, const TouchMemory& touches, const PresenceMemory& presence,
                   AreaFoulMemory& memory);

/// What becomes of a goal while area fouls wait: it stands after a foul of the defenders, it is a goal kick
/// after one of the attackers; after both the one counts that `AreaRules::both` names.
Finding decideGoal(const DetectorInput& input, const Finding& goal, const AreaFoulMemory& memory);

/// The call that is due, if one is: when the foul has waited long enough or the ball has left the area. Of
/// two at the same goal the one that `AreaRules::both` names.
std::optional<Finding> decideAreaFouls(const DetectorInput& input, const AreaFoulMemory& memory);

}  // namespace fulbito
