#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fulbito::app {

/// What `fulbito replay events` was asked.
struct ReplayEventsCommand {
  std::string file;
  bool json = false;
};

/// Adds `events` to `replay`.
CLI::App* addReplayEvents(CLI::App& replay, ReplayEventsCommand& options);

/// Runs it and returns the exit code.
int replayEvents(const ReplayEventsCommand& options);

}  // namespace fulbito::app
