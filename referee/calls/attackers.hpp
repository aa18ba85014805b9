// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Law 8.2: more attackers than allowed in the opponents' goal area (or big area), where the rules say so
/// only if one beyond the first takes part: it touched the ball or the keeper within `part_seconds`.
std::optional<AreaFoul> detectAttackers(const DetectorInput& input, const TouchMemory& touches,
                                        const PresenceMemory& presence);

}  // namespace fulbito
