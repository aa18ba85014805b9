#pragma once

#include "fulbito/match.hpp"

namespace fulbito {

/// What a team would see now without errors, in its own frame.
Observation truthFor(const Match& match, TeamId team);

}  // namespace fulbito
