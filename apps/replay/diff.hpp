#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito replay diff`.
struct ReplayDiffCommand {
  std::string a;
  std::string b;
  bool json = false;
};

/// Adds `diff` to `replay`.
CLI::App* addReplayDiff(CLI::App& replay, ReplayDiffCommand& options);

/// Runs the command and returns its exit code.
int replayDiff(const ReplayDiffCommand& options);

}  // namespace fulbito::app
