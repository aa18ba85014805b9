#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "tournament/formats/standings.hpp"
#include "tournament/runner/runner.hpp"
#include "tournament/statistics/elo.hpp"
#include "tournament/statistics/ratings.hpp"

namespace fulbito {

/// One team's results against one other team, against all, or from one kind of start.
struct MeetingSummary {
  int pairs = 0;
  int won = 0, drawn = 0, lost = 0;  ///< matches
  int goals_for = 0, goals_against = 0;
  Interval points_share;  ///< mean with `shareInterval` over pairs
  EloEstimate elo;
};

/// Number of kinds of `MatchOutcome`.
inline constexpr std::size_t kMatchOutcomes = 6;

/// How often a team had each outcome, and the reason of its last failure.
struct FaultSummary {
  /// Number of matches by `MatchOutcome`: the team's own worst fault; kMercy counts the matches it lost
  /// early.
  std::array<int, kMatchOutcomes> outcomes{};
  std::string last_failure;  ///< reason of the last failure in the schedule; empty: none

  /// Number of matches with the given outcome.
  int of(MatchOutcome outcome) const { return outcomes[static_cast<std::size_t>(outcome)]; }
};

/// A match that deserves a look.
struct NotableMatch {
  std::size_t fixture = 0, leg = 0;
  MatchId id;
  std::string why;  ///< "upset: classic (-210) beat libero (+210)", "classic lost 0:4 from free-ball:3"
};

/// Largest number of notable matches.
inline constexpr std::size_t kMostNotable = 20;
/// Largest number of steps of a rating's course.
inline constexpr std::size_t kCourseSteps = 20;

/// Everything that reports show. It is the same for any order of play.
struct TournamentTable {
  std::vector<Standing> standings;
  std::vector<KnockOutTie> bracket;
  Ratings ratings;
  std::vector<std::vector<MeetingSummary>> cross;   ///< [row entrant][column entrant]
  std::vector<std::vector<MeetingSummary>> starts;  ///< [entrant][StartKind]
  std::vector<MeetingSummary> totals;               ///< by entrant: the sum of all its matches
  std::vector<FaultSummary> faults;                 ///< by entrant
  std::vector<NotableMatch> notable;                ///< worst first, at most `kMostNotable`
  bool recorded = false;                            ///< whether all of `notable` have recordings
  /// Elo as [entrant][step], after each twentieth of the fixtures that count; NaN before the entrant's first
  /// match. With fewer fixtures than `kCourseSteps` there is one step per fixture.
  std::vector<std::vector<double>> course;
};

/// Computes the table of a tournament so far.
/// @param resamples  number of bootstrap resamples for intervals and superiority, see `rate`
TournamentTable tableOf(const TournamentState& state, std::size_t resamples = 1000);

}  // namespace fulbito
