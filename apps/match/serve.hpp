#pragma once

#include "apps/match/match.hpp"
#include "apps/match/simulate.hpp"
#include "bridge/wire/wire_settings.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito serve`.
struct ServeCommand {
  MatchCommand match;       ///< its teams are specifications, or empty for clients
  wire::WireSettings wire;  ///< of both clients
  bool no_referee = false;  ///< the simulator alone, as these say
  SimulateOptions alone;
};

/// Adds `serve`.
CLI::App* addServe(CLI::App& app, ServeCommand& options);

/// Runs the command and returns its exit code.
int serve(const ServeCommand& options);

}  // namespace fulbito::app
