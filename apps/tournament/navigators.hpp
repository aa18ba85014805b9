#pragma once

#include "tournament/navigators/navigator_tournament.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito tournament navigators`.
struct NavigatorsCommand {
  NavigatorTournamentConfig config;
  bool json = false;
};

/// Adds `navigators` to `tournament`.
CLI::App* addNavigators(CLI::App& tournament, NavigatorsCommand& options);

/// Runs the command and returns its exit code.
int navigators(const NavigatorsCommand& options);

}  // namespace fulbito::app
