#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "match/check/situations.hpp"
#include "match/check/watched_team.hpp"

namespace fulbito {

/// One finding and the situations in which it was made.
struct FoundIn {
  std::int64_t count = 0;
  std::string first;  ///< the first of these situations; empty: none
  /// Adds `more` findings of a situation.
  void add(std::int64_t more, const std::string& situation);
};

/// The findings of all scripted situations together.
struct PlayFindings {
  int situations = 0;  ///< played
  int broken = 0;      ///< of these, ended early: the team forfeited or was late too often
  int skipped = 0;     ///< not played, since too many before them ended early
  FoundIn failures, stale, not_finite, no_navigator, saturated, late, repaired;
  std::string reason;         ///< reason of the first failure
  bool forfeited = false;     ///< it failed so often that it lost by walk-over
  std::int64_t commands = 0;  ///< commands of single robots that reached the motors
  TeamNotes notes;
  DecisionTime limit;  ///< decision time that the team has
};

/// Plays a situation with the team in its seat and adds the findings. Errors: as `Match::create`.
Result<void> playSituation(const CheckSituation& situation, const TeamChoice& team, const MatchClock& clock,
                           PlayFindings& findings);

}  // namespace fulbito
