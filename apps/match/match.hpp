#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/match/team_flags.hpp"
#include "apps/match/view.hpp"
#include "fulbito/match.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito match`.
struct MatchCommand {
  std::string blue = "libero";
  std::string yellow = "classic";
  std::string rules = "vsss-3v3";
  std::string physics = "standard";
  std::string robot = "vsss";
  std::uint64_t seed = kDefaultMatchSeed;
  std::optional<double> half_seconds;  ///< empty: the profile's
  std::string start;                   ///< start state file; empty: a kick-off
  /// @{ How teams see: one value for both, or blue's and yellow's.
  std::vector<int> latency_ticks{0};
  std::vector<double> position_noise{0.0};  ///< [m]
  std::vector<double> dropout{0.0};
  /// @}
  std::string time;            ///< [ms] that a decision may take, or "unlimited"; empty: by the rules
  TeamFlags outside;           ///< teams that are files or programs
  std::string record;          ///< file; empty: none
  bool record_recipe = false;  ///< the recording holds only what cannot be computed again
  bool drawings = false;       ///< the recording also holds what the teams draw
  std::string events;          ///< file or "-"; empty: none
  std::optional<int> pairs;    ///< empty: one match
  int jobs = 0;
  bool view = false;  ///< play in a window
  ViewOptions window;
  bool profile = false;
  bool json = false;
  bool force = false;  ///< replace existing files
};

/// Adds `match`.
CLI::App* addMatch(CLI::App& app, MatchCommand& options);

/// Runs the command and returns its exit code.
int match(const MatchCommand& options);

}  // namespace fulbito::app
