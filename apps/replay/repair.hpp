#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito replay repair`.
struct ReplayRepairCommand {
  std::string file;
  std::string out;
  bool force = false;
  bool json = false;
};

/// Adds `repair` to `replay`.
CLI::App* addReplayRepair(CLI::App& replay, ReplayRepairCommand& options);

/// Runs the command and returns its exit code.
int replayRepair(const ReplayRepairCommand& options);

}  // namespace fulbito::app
