#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/common/sensor_options.hpp"
#include "apps/common/team_flags.hpp"
#include "fulbito/match.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of all commands that play matches: teams, rules, models, vision and time limits.
struct MatchSettings {
  std::string blue = "libero";
  std::string yellow = "classic";
  std::string rules = "vsss-3v3";
  std::string physics = "standard";
  std::string robot = "vsss";
  std::uint64_t seed = kDefaultMatchSeed;
  std::optional<double> half_seconds;  ///< [s] length of a half; empty: as in the rules
  std::string start;                   ///< file with a start state; empty: a kick-off
  SeatSensors sensors;                 ///< vision of both teams, or of blue and yellow
  std::string time;                    ///< [ms] limit for a decision, or "unlimited"; empty: as in the rules
  TeamFlags outside;                   ///< options for teams that are files or programs
};

/// Adds all options except those for the teams, which each command adds itself.
/// @param seats  names of the two teams that the two values of a list belong to
void addMatchSettings(CLI::App& command, MatchSettings& settings, const char* seats = "BLUE,YELLOW");

/// The configuration of the match. Errors: as the loaders of its parts; kUsage naming the flag.
Result<MatchConfig> configOf(const MatchSettings& settings);
/// As `configOf`, but without teams.
Result<MatchConfig> configWithoutTeams(const MatchSettings& settings);

}  // namespace fulbito::app
