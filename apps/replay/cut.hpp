#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// What `fulbito replay cut` was asked.
struct ReplayCutCommand {
  std::string file;
  std::string out;
  std::optional<double> from;  ///< [s] of the recording
  std::optional<double> to;    ///< [s]
  std::string plays;           ///< A-B, counted from 1
  bool force = false;
  bool json = false;
};

/// Adds `cut` to `replay`.
CLI::App* addReplayCut(CLI::App& replay, ReplayCutCommand& options);

/// Runs it and returns the exit code.
int replayCut(const ReplayCutCommand& options);

}  // namespace fulbito::app
