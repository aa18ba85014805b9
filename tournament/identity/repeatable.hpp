#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Whether a team answers the same questions twice in the same way, in a few situations of `fulbito
/// check-team` (match/check). False for a team that stops answering. Errors: of the team.
Result<bool> repeatsItself(const TeamChoice& team);

}  // namespace fulbito
