#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// What `fulbito replay diff` was asked.
struct ReplayDiffCommand {
  std::string a;
  std::string b;
  bool json = false;
};

/// Adds `diff` to `replay`.
CLI::App* addReplayDiff(CLI::App& replay, ReplayDiffCommand& options);

/// Runs it and returns the exit code.
int replayDiff(const ReplayDiffCommand& options);

}  // namespace fulbito::app
