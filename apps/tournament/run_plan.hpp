#pragma once

#include <optional>
#include <string>

#include "tournament/folder/results_folder.hpp"
#include "tournament/runner/runner.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// How a tournament is run: none of it changes results.
struct RunFlags {
  std::string out;  ///< folder; empty: nothing is kept
  int jobs = 0;
  std::string shard;   ///< see `shardOf`
  std::string cache;   ///< folder; empty: none
  std::string verify;  ///< share of the matches to play again: "1%"
  std::string recordings = "none";
  bool strict = false;  ///< exit code 4 if a team crashed or forfeited
};

/// Adds --out, --jobs, --shard, --cache, --verify and --strict.
void addRunFlags(CLI::App& command, RunFlags& flags);
/// Adds --recordings.
void addRecordings(CLI::App& command, RunFlags& flags);

/// A tournament after a run.
struct PlayedPlan {
  PlanRecord record;
  RunOutcome outcome;
  Shard shard;
};

/// Plays what is missing of a plan, with progress on stderr. Errors: of the plan, its teams, folders, flags.
Result<PlayedPlan> runPlan(const TournamentPlan& plan, const RunFlags& flags);

/// Says on stderr what a report leaves out: matches that were played again and differ, retries, what to do
/// next.
void noteOutcome(const PlayedPlan& played, const RunFlags& flags);

/// The exit code of a run: 7 for matches that differ, 4 for failed teams where that counts, that of a signal,
/// 6 for matches that the machine failed, then that of the test if there is one.
int exitCodeOf(const PlayedPlan& played, const RunFlags& flags);
/// The exit code of the test of a tournament; 0 without one.
int exitCodeOf(const TournamentState& state);

}  // namespace fulbito::app
