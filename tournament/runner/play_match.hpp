#pragma once

#include <functional>

#include "fulbito/match.hpp"
#include "tournament/results/results.hpp"
#include "tournament/runner/turns.hpp"

namespace fulbito {

/// Plays a match to its end and returns its result. `goes_on` is called once per simulated minute; false
/// stops the match. `observer` may be null. Errors: as `Match::create`; kInterrupted when `goes_on` returned
/// false; the error of an abandoned match (`MatchFaults::abandoned`).
Result<MatchResult> playMatch(const MatchConfig& config, const MatchClock& clock,
                              const std::function<bool()>& goes_on, MatchObserver* observer,
                              Turns* turns = nullptr);

/// Whether a team of the match runs in another process.
bool hasOutsideTeam(const MatchConfig& config);

/// The outcome of a match from its faults; `mercy`: the lead that the rules name ended it.
MatchOutcome outcomeOf(const MatchFaults& faults, bool walk_over, bool mercy);

}  // namespace fulbito
