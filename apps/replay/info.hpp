#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito replay info`.
struct ReplayInfoCommand {
  std::string file;
  bool json = false;
};

/// Adds `info` to `replay`.
CLI::App* addReplayInfo(CLI::App& replay, ReplayInfoCommand& options);

/// Runs the command and returns its exit code.
int replayInfo(const ReplayInfoCommand& options);

}  // namespace fulbito::app
