#pragma once

#include <cstdint>
#include <string>

#include "apps/common/team_flags.hpp"
#include "fulbito/match.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito check-team`.
struct CheckTeamCommand {
  std::string team;  ///< specification of the team
  std::uint64_t seed = kDefaultMatchSeed;
  int jobs = 0;
  bool quick = false;
  bool json = false;
  std::string junit;  ///< JUnit file; empty: none
  TeamFlags outside;
};

/// Adds `check-team`.
CLI::App* addCheckTeam(CLI::App& app, CheckTeamCommand& options);
/// Checks a team, prints the report and returns the exit code.
int checkTeam(const CheckTeamCommand& options);

}  // namespace fulbito::app
