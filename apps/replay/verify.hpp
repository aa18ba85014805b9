#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fulbito::app {

/// What `fulbito replay verify` was asked.
struct ReplayVerifyCommand {
  std::vector<std::string> files;  ///< or folders
  int jobs = 0;
  bool json = false;
};

/// Adds `verify` to `replay`.
CLI::App* addReplayVerify(CLI::App& replay, ReplayVerifyCommand& options);

/// Runs it and returns the exit code.
int replayVerify(const ReplayVerifyCommand& options);

}  // namespace fulbito::app
