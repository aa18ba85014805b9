#pragma once

#include <string>

#include "fulbito/outside.hpp"
#include "fulbito/strategy.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Flags for teams that are files or programs.
struct TeamFlags {
  std::string isolate = "process";
  std::string sandbox = "best";
  double memory_mb = 1024.0;
  int processes = ChildLimits{}.processes;
  bool network = false;
};

/// Adds --isolate, --sandbox, --team-memory, --team-processes and --team-network.
void addTeamFlags(CLI::App& command, TeamFlags& flags);

/// Built-in teams, and teams that are files or programs. Their stderr goes to the stderr of this program.
TeamCatalogue catalogueOf(const TeamFlags& flags);

}  // namespace fulbito::app
