#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/common/match_settings.hpp"
#include "apps/match/view.hpp"
#include "apps/tournament/run_plan.hpp"
#include "fulbito/match.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito match`.
struct MatchCommand {
  MatchSettings settings;
  std::string record;          ///< recording file; empty: none
  bool record_recipe = false;  ///< the recording contains only what cannot be simulated again
  bool drawings = false;       ///< the recording also contains debug drawings of the teams
  std::string events;          ///< file for events, or "-"; empty: none
  std::optional<int> pairs;    ///< number of pairs in a series; empty: a single match
  RunFlags series;             ///< options of a series
  bool view = false;           ///< play the match in a window
  ViewOptions window;
  bool profile = false;
  bool json = false;
  bool force = false;  ///< replace existing files
};

/// Adds the options that name files for a single match.
void addMatchOutputs(CLI::App& command, MatchCommand& options);

/// Adds `match`.
CLI::App* addMatch(CLI::App& app, MatchCommand& options);

/// Runs the command and returns its exit code.
int match(const MatchCommand& options);

}  // namespace fulbito::app
