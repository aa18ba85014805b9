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

/// What commands that play matches take: teams, rules, models, what teams see and how long they may think.
struct MatchSettings {
  std::string blue = "libero";
  std::string yellow = "classic";
  std::string rules = "vsss-3v3";
  std::string physics = "standard";
  std::string robot = "vsss";
  std::uint64_t seed = kDefaultMatchSeed;
  std::optional<double> half_seconds;  ///< empty: the profile's
  std::string start;                   ///< start state file; empty: a kick-off
  SeatSensors sensors;                 ///< of both teams, or of blue and yellow
  std::string time;                    ///< [ms] that a decision may take, or "unlimited"; empty: by the rules
  TeamFlags outside;                   ///< teams that are files or programs
};

/// Adds the options; the teams are left to the command.
/// @param seats  whom the two values of a list belong to
void addMatchSettings(CLI::App& command, MatchSettings& settings, const char* seats = "BLUE,YELLOW");

/// The match that they describe. Errors: as the loaders of its parts, kUsage naming the flag.
Result<MatchConfig> configOf(const MatchSettings& settings);
/// The same with empty teams.
Result<MatchConfig> configWithoutTeams(const MatchSettings& settings);

}  // namespace fulbito::app
