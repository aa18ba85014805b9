#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tournament/runner/runner.hpp"
#include "tournament/statistics/pentanomial.hpp"
#include "tournament/tune/tune_plan.hpp"

namespace fulbito {

/// Options that do not affect the path of a tuning.
struct TuneOptions {
  int jobs = 0;               ///< matches played at once; 0: one per core
  MatchClock clock;           ///< monotonic time [ns]
  MatchStore* log = nullptr;  ///< store of finished matches, from which a tuning continues; required
  /// Called with each finished match, from one thread at a time. False stops the run.
  std::function<bool(const RunProgress&)> progress;
};

/// The result of a final match-up.
struct FinalResult {
  std::string first, second;
  PairCounts counts;           ///< pairs by score of the first team
  std::vector<double> points;  ///< by start: the first team's share of the pair's points, 0 ... 1
};

/// The results of a tuning so far.
struct TuneOutcome {
  std::vector<double> results;      ///< results of the iterations, in order
  std::vector<FinalResult> finals;  ///< final match-ups, after all iterations have results
  std::size_t played = 0;           ///< matches that this run played
  std::size_t taken = 0;            ///< matches taken from the log
  std::size_t failures = 0;         ///< matches in which a team crashed or forfeited
  /// Matches for which another run of the tuning stored a different result.
  std::vector<Mismatch> mismatches;
  /// Matches that the machine failed. The tuning stops after them, because its next step needs their results.
  std::vector<UnplayedMatch> unplayed;
  bool interrupted = false;
};

/// Number of matches of a whole tuning.
std::size_t matchesOf(const TunePlan& plan);

/// Plays the missing matches of a tuning, iteration by iteration. The path depends only on the plan, not on
/// `jobs` or interruptions. Errors: as `validate`, `iterationPlan`, `runTournament`.
Result<TuneOutcome> runTune(const TunePlan& plan, const TeamCatalogue& teams, const TuneOptions& options);

}  // namespace fulbito
