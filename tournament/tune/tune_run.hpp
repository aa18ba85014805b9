#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tournament/runner/runner.hpp"
#include "tournament/statistics/pentanomial.hpp"
#include "tournament/tune/tune_plan.hpp"

namespace fulbito {

/// How a tuning is run. None of this affects its path.
struct TuneOptions {
  int jobs = 0;               ///< matches at once; 0: one per core
  MatchClock clock;           ///< monotonic time [ns]
  MatchStore* log = nullptr;  ///< finished matches: a tuning continues from them; required
  /// Called with each finished match, from one thread at a time. False stops the run.
  std::function<bool(const RunProgress&)> progress;
};

/// The result of a final match-up.
struct FinalResult {
  std::string first, second;
  PairCounts counts;           ///< of the first
  std::vector<double> points;  ///< of the first by start: share of the pair's points, 0 ... 1
};

/// What a tuning has so far.
struct TuneOutcome {
  std::vector<double> results;       ///< of the iterations, in order
  std::vector<FinalResult> finals;   ///< once all iterations have results
  std::size_t played = 0;            ///< matches of this run
  std::size_t taken = 0;             ///< from the log
  std::size_t failures = 0;          ///< matches in which a team crashed or forfeited
  std::vector<Mismatch> mismatches;  ///< matches that another run of the tuning played with another result
  /// Matches that the machine failed: the tuning ends before its next step, which needs their results.
  std::vector<UnplayedMatch> unplayed;
  bool interrupted = false;
};

/// Matches of a whole tuning.
std::size_t matchesOf(const TunePlan& plan);

/// Plays what is missing of a tuning, iteration by iteration. The path is a pure function of the plan:
/// neither `jobs` nor stops change it. Errors: as `validate`, `iterationPlan`, `runTournament`.
Result<TuneOutcome> runTune(const TunePlan& plan, const TeamCatalogue& teams, const TuneOptions& options);

}  // namespace fulbito
