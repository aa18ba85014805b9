#pragma once

#include <optional>
#include <string>

#include "tournament/folder/results_folder.hpp"
#include "tournament/runner/runner.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of a tournament run that do not affect its results.
struct RunFlags {
  std::string out;  ///< folder for the results; empty: results are not stored
  int jobs = 0;
  std::string shard;   ///< see `shardOf`
  std::string cache;   ///< folder of the cache; empty: none
  std::string verify;  ///< share of the matches to play again and compare: "1%"
  std::string recordings = "none";
  bool strict = false;  ///< whether a crashed or forfeiting team gives exit code 4
};

/// Adds --out, --jobs, --shard, --cache, --verify and --strict.
void addRunFlags(CLI::App& command, RunFlags& flags);
/// Adds --recordings.
void addRecordings(CLI::App& command, RunFlags& flags);

/// A tournament and the outcome of its run.
struct PlayedPlan {
  PlanRecord record;
  RunOutcome outcome;
  Shard shard;
};

/// Plays the missing matches of a plan, with progress on stderr. Errors: of the plan, its teams, folders,
/// flags.
Result<PlayedPlan> runPlan(const TournamentPlan& plan, const RunFlags& flags);

/// Prints notes on stderr that are not part of a report: matches that differ when played again, retries, what
/// to do next.
void noteOutcome(const PlayedPlan& played, const RunFlags& flags);

/// The exit code of a run, by precedence: 7 for matches that differ; 4 for failed teams with `strict`; that
/// of a signal; 6 for matches that the machine failed; that of the sequential test, if there is one.
int exitCodeOf(const PlayedPlan& played, const RunFlags& flags);
/// The exit code of the sequential test of a tournament; 0 without one.
int exitCodeOf(const TournamentState& state);

}  // namespace fulbito::app
