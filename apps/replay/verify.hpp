#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito replay verify`.
struct ReplayVerifyCommand {
  std::vector<std::string> files;  ///< or folders
  int jobs = 0;
  bool json = false;
};

/// Adds `verify` to `replay`.
CLI::App* addReplayVerify(CLI::App& replay, ReplayVerifyCommand& options);

/// Runs the command and returns its exit code.
int replayVerify(const ReplayVerifyCommand& options);

}  // namespace fulbito::app
