#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// What `fulbito replay info` was asked.
struct ReplayInfoCommand {
  std::string file;
  bool json = false;
};

/// Adds `info` to `replay`.
CLI::App* addReplayInfo(CLI::App& replay, ReplayInfoCommand& options);

/// Runs it and returns the exit code.
int replayInfo(const ReplayInfoCommand& options);

}  // namespace fulbito::app
