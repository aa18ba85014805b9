#pragma once

#include <string>
#include <vector>

#include "apps/tournament/navigators.hpp"
#include "apps/tournament/plan_settings.hpp"
#include "apps/tournament/report_files.hpp"
#include "apps/tournament/run_plan.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito tournament run`.
struct TournamentRun {
  CLI::App* command = nullptr;     ///< tells which flags were given
  std::vector<std::string> words;  ///< a plan file, or teams
  PlanSettings settings;
  RunFlags flags;
  ReportFiles files;
  bool dry = false;  ///< print the first fixtures without playing
};

/// Options of `fulbito tournament report`.
struct TournamentReport {
  std::string folder;
  std::string recordings = "none";  ///< "none" or "upsets"
  TeamFlags outside;                ///< options of teams for the matches to record
  ReportFiles files;
};

/// Options of `fulbito tournament merge`.
struct TournamentMerge {
  std::vector<std::string> folders;
  std::string out;
  ReportFiles files;
};

/// Options of all subcommands of `fulbito tournament`.
struct TournamentCommand {
  std::string part;
  TournamentRun run;
  TournamentReport report;
  TournamentMerge merge;
  NavigatorsCommand navigators;
};

/// Adds `tournament`.
void addTournament(CLI::App& app, TournamentCommand& options);

/// Runs the subcommand and returns its exit code.
int tournament(const CLI::App& app, TournamentCommand& options);

}  // namespace fulbito::app
