#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito replay cut`.
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

/// Runs the command and returns its exit code.
int replayCut(const ReplayCutCommand& options);

}  // namespace fulbito::app
