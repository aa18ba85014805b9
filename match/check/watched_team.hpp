#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "fulbito/match.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// The match asks for a decision.
struct DecideCall {
  Observation seen;
};
/// The match tells that a new play is placed.
struct ReadyCall {
  Observation seen;
};
/// One call of a match to its team.
using TeamCall = std::variant<PlacementRequest, ReadyCall, DecideCall, PlayStop>;

/// The calls of a match to one team.
struct RecordedCalls {
  MatchInfo info;
  std::vector<TeamCall> calls;
};

/// Notes on a team during its matches.
struct TeamNotes {
  double start_seconds = 0.0;   ///< [s] the longest creation and start
  std::vector<double> seconds;  ///< [s] time of each decision
  std::int64_t unasked = 0;     ///< decisions with drawings that the match did not ask for
  std::int64_t with_roles = 0;  ///< decisions that report a role
  std::vector<Setting> origin;  ///< the team's own report of its version, hash and containment
};

/// The same team; its matches fill in `notes`, which must outlive them. They must run one after the other.
TeamChoice watchedTeam(const TeamChoice& team, const MatchClock& clock, TeamNotes& notes);

/// The same team; `kept` records all calls of its match and must outlive it.
TeamChoice overheardTeam(const TeamChoice& team, RecordedCalls& kept);

}  // namespace fulbito
