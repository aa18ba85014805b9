#pragma once

#include <string>

#include "match/check/answers.hpp"
#include "match/check/situations.hpp"

namespace fulbito {

/// Comparison of the answers of two instances of a team over all situations; they should be equal.
struct RepeatFindings {
  std::int64_t compared = 0;   ///< answers
  std::int64_t different = 0;  ///< answers that differ
  std::string first;           ///< place of the first difference; empty: none
  std::string failure;         ///< reason why the team stopped answering; empty: it answered all
};

/// The three comparisons of recorded situations.
struct AllRepeats {
  RepeatFindings again;   ///< the same calls told twice
  RepeatFindings seat;    ///< the same calls told in the other seat
  RepeatFindings mirror;  ///< the mirrored calls
};

/// Plays the situation with built-in teams, records the calls to its seat and tells them to four new
/// instances of the team. Errors: of the teams.
Result<void> repeatSituation(const CheckSituation& situation, const TeamChoice& team, AllRepeats& findings);

}  // namespace fulbito
