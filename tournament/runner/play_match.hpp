#pragma once

#include <functional>

#include "fulbito/match.hpp"
#include "tournament/results/results.hpp"
#include "tournament/runner/turns.hpp"

namespace fulbito {

/// Plays a match to its end and sums it up. `goes_on` is asked about once per simulated minute; `observer`
/// may be null. Errors: as `Match::create`; kInterrupted when `goes_on` said no; that of a match that was
/// abandoned (`MatchFaults::abandoned`).
Result<MatchResult> playMatch(const MatchConfig& config, const MatchClock& clock,
                              const std::function<bool()>& goes_on, MatchObserver* observer,
                              Turns* turns = nullptr);

/// Whether a team runs in another process.
bool hasOutsideTeam(const MatchConfig& config);

/// How the match ended, by its faults; `mercy`: by the lead that the rules name.
MatchOutcome outcomeOf(const MatchFaults& faults, bool walk_over, bool mercy);

}  // namespace fulbito
