#pragma once

#include <string>
#include <vector>

#include "apps/common/team_flags.hpp"
#include "match/drills/drill.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// The command line of `fulbito drill`.
struct DrillCommand {
  std::vector<std::string> teams;    ///< with more than one, all are in one table
  std::vector<std::string> drills;   ///< numbers or names
  std::vector<std::string> without;  ///< skills to leave out, one at a time
  DrillOptions run;
  TeamFlags outside;   ///< options for teams that are files or programs
  std::string folder;  ///< folder with drills; empty: the built-in drills
  bool json = false;
  bool check = false;
  bool list = false;
};

CLI::App* addDrill(CLI::App& app, DrillCommand& options);
/// Runs the command and returns its exit code.
int drill(DrillCommand options);

}  // namespace fulbito::app
