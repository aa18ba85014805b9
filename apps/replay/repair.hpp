#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// What `fulbito replay repair` was asked.
struct ReplayRepairCommand {
  std::string file;
  std::string out;
  bool force = false;
  bool json = false;
};

/// Adds `repair` to `replay`.
CLI::App* addReplayRepair(CLI::App& replay, ReplayRepairCommand& options);

/// Runs it and returns the exit code.
int replayRepair(const ReplayRepairCommand& options);

}  // namespace fulbito::app
