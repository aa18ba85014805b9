#pragma once

#include <string>
#include <vector>

#include "apps/common/match_settings.hpp"
#include "tournament/plan/plan.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// A team as flags or a plan file name it.
struct EntrantSettings {
  std::string team;                ///< specification
  std::string name;                ///< empty: the specification
  std::vector<std::string> files;  ///< what determines it besides its specification
};

/// A tournament as flags or a plan file describe it.
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
  MatchSettings match;  ///< its teams are not used
};

/// Adds --starts and --starts-seed.
void addStarts(CLI::App& command, PlanSettings& settings);
/// Adds --bounds, --alpha and --beta.
void addBounds(CLI::App& command, PlanSettings& settings);

/// Reads a plan file (docs/tournaments.md). Errors: kIo; kBadInput as `file:line: table.key ...`.
Result<PlanSettings> readPlanFile(const std::string& file);

/// The plan that they describe, with its teams. Errors: of teams, models and rules; kUsage naming the flag.
Result<TournamentPlan> planOf(const PlanSettings& settings);

}  // namespace fulbito::app
