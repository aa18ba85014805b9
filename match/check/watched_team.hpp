#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "fulbito/match.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// A decision is asked for.
struct DecideCall {
  Observation seen;
};
/// A new play is placed.
struct ReadyCall {
  Observation seen;
};
/// One call of a match to its team.
using TeamCall = std::variant<PlacementRequest, ReadyCall, DecideCall, PlayStop>;

/// What a match tells one team.
struct RecordedCalls {
  MatchInfo info;
  std::vector<TeamCall> calls;
};

/// What is noted of a team during its matches.
struct TeamNotes {
  double start_seconds = 0.0;   ///< [s] the longest creation and start
  std::vector<double> seconds;  ///< [s] of each decision
  std::int64_t unasked = 0;     ///< decisions with drawings that nobody wanted
  std::int64_t with_roles = 0;  ///< decisions that tell a role
  std::vector<Setting> origin;  ///< as the team tells it
};

/// The same team, noting its decisions. `notes` outlives its matches, which run one after the other.
TeamChoice watchedTeam(const TeamChoice& team, const MatchClock& clock, TeamNotes& notes);

/// The same team, keeping all that its match tells it. `kept` outlives the match.
TeamChoice overheardTeam(const TeamChoice& team, RecordedCalls& kept);

}  // namespace fulbito
