#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito replay events`.
struct ReplayEventsCommand {
  std::string file;
  bool json = false;
};

/// Adds `events` to `replay`.
CLI::App* addReplayEvents(CLI::App& replay, ReplayEventsCommand& options);

/// Runs the command and returns its exit code.
int replayEvents(const ReplayEventsCommand& options);

}  // namespace fulbito::app
