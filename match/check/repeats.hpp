#pragma once

#include <string>

#include "match/check/answers.hpp"
#include "match/check/situations.hpp"

namespace fulbito {

/// Answers of two instances of a team that should be the same, over all situations.
struct RepeatFindings {
  std::int64_t compared = 0;   ///< answers
  std::int64_t different = 0;  ///< of these
  std::string first;           ///< where the first difference is; empty: nowhere
  std::string failure;         ///< why the team stopped answering, if it did
};

/// The three comparisons of recorded situations.
struct AllRepeats {
  RepeatFindings again;   ///< the same calls told twice
  RepeatFindings seat;    ///< the same calls told in the other seat
  RepeatFindings mirror;  ///< the mirrored calls
};

/// Plays the situation with built-in teams, keeps what its seat is told and tells it to four new instances of
/// the team. Errors: of the teams.
Result<void> repeatSituation(const CheckSituation& situation, const TeamChoice& team, AllRepeats& findings);

}  // namespace fulbito
