#pragma once

#include <string>
#include <vector>

#include "fulbito/match.hpp"

namespace fulbito {

/// One scripted situation: a short match with the tested team in one seat.
struct CheckSituation {
  std::string name;             ///< such as "penalty, theirs"
  MatchConfig match;            ///< all settings but the tested team
  TeamId seat = TeamId::kBlue;  ///< seat of the tested team
  Tick ticks = 0;               ///< ticks to play
};

/// The situations for a team in that seat: all kinds of restarts, for and against it; balls in corners; teams
/// that lack robots; five robots; and a longer piece of play. The team has the decision time of the rules.
/// Errors: of presets.
Result<std::vector<CheckSituation>> checkSituations(TeamId seat, std::uint64_t seed, bool quick);

}  // namespace fulbito
