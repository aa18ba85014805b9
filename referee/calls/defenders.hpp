// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Law 8.3: more defenders than allowed in their own goal area (or big area) with the ball inside, where the
/// rules say so only if one beyond the first takes part: it touched the ball or an opponent within
/// `part_seconds`.
std::optional<AreaFoul> detectDefenders(const DetectorInput& input, const TouchMemory& touches,
                                        const PresenceMemory& presence);

}  // namespace fulbito
