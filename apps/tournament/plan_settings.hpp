#pragma once

#include <string>
#include <vector>

#include "apps/common/match_settings.hpp"
#include "tournament/plan/plan.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// A team, as given by flags or a plan file.
struct EntrantSettings {
  std::string team;                ///< specification
  std::string name;                ///< name of the team; empty: the specification
  std::vector<std::string> files;  ///< files that determine the team, besides its specification
};

/// A tournament, as given by flags or a plan file.
struct PlanSettings {
  std::string name = "tournament";
  std::string format = "round-robin";
  std::vector<EntrantSettings> entrants;
  int pairs = 1;
  int rounds = 0;
  int groups = 1;
  std::vector<std::string> starts{"kick-off"};
  std::uint64_t starts_seed = 1;
  std::vector<double> bounds;  ///< normalized Elo of H0 and H1; empty: no test
  double alpha = 0.05;
  double beta = 0.05;
  MatchSettings match;  ///< settings of all matches; its teams are not used
};

/// Adds --starts and --starts-seed.
void addStarts(CLI::App& command, PlanSettings& settings);
/// Adds --bounds, --alpha and --beta.
void addBounds(CLI::App& command, PlanSettings& settings);

/// Reads a plan file (docs/tournaments.md). Errors: kIo; kBadInput as `file:line: table.key ...`.
Result<PlanSettings> readPlanFile(const std::string& file);

/// The tournament plan with its teams. Errors: of teams, models and rules; kUsage naming the flag.
Result<TournamentPlan> planOf(const PlanSettings& settings);

}  // namespace fulbito::app
