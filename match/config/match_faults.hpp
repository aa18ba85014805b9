#pragma once

#include <cstdint>
#include <optional>

#include "engine/core/base/result.hpp"
#include "engine/core/base/team.hpp"

namespace fulbito {

/// What one team did that the match's policy had to answer (docs/matches.md). Nothing here ends a match.
struct TeamFaults {
  std::int64_t not_finite = 0;  ///< robots' commands with a NaN or infinity: that robot stopped for the tick
  std::int64_t no_navigator = 0;  ///< robots' commands by a navigator that the team lacks: stopped as well
  std::int64_t saturated = 0;     ///< robots' commands beyond motors or field, which were cut: no fault
  std::int64_t late = 0;          ///< decisions beyond `MatchConfig::decision_time`: the one before held

  /// All commands and decisions that were not carried out.
  std::int64_t rejected() const { return not_finite + no_navigator + late; }
};

/// The faults of a whole match.
struct MatchFaults {
  PerTeam<TeamFaults> teams;
  /// Why the match could not go on: a restart's state was no possible world. It ended there, unfinished.
  std::optional<Error> abandoned;
};

}  // namespace fulbito
