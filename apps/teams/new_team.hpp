#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito new-team`.
struct NewTeamCommand {
  std::string kind;    ///< cpp, c, python or program
  std::string folder;  ///< folder to create
  std::string name;    ///< name of the team; empty: that of the folder
};

/// Adds `new-team`.
CLI::App* addNewTeam(CLI::App& app, NewTeamCommand& options);
/// Writes a first version of a team and returns the exit code.
int newTeam(const NewTeamCommand& options);

}  // namespace fulbito::app
