#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fulbito/experiment.hpp"
#include "tournament/navigators/navigator_table.hpp"

namespace fulbito {

/// A tournament of navigators: all drive through the same layouts of a suite.
struct NavigatorTournamentConfig {
  std::string suite = "moving";         ///< name of the suite
  std::vector<std::string> navigators;  ///< specifications, none twice; empty: all built-in ones
  std::optional<double> speed;          ///< [m/s] top speed; empty: the first speed of the suite
  int trials = 0;                       ///< number of layouts; 0: that of the suite
  std::uint64_t seed = 2015;            ///< seed of layouts, sensor noise and resamples
  int jobs = 0;                         ///< worker threads; 0: all cores
  std::string robot = "jung-lee-2015";  ///< preset or file
  std::string physics = "standard";     ///< preset or file
  SensorModel sensors;                  ///< noise and limits of observations
};

/// A finished tournament of navigators.
struct NavigatorTournament {
  Comparison comparison;  ///< one block, with the records of all trials
  double tie = 0.0;       ///< [s] largest difference of times that counts as a draw: one control tick
  NavigatorTable table;
};

/// Checks names, files and ranges without running a trial. Errors: kUsage, kIo, kBadInput.
Result<Comparison> planNavigatorTournament(const NavigatorTournamentConfig& config);

/// Runs all trials on worker threads; their number does not affect the result. Errors: those of the plan and
/// of the trials; kInterrupted if `progress` returned false.
Result<NavigatorTournament> runNavigatorTournament(const NavigatorTournamentConfig& config,
                                                   const Progress& progress);

/// @{ Reports. Equal tournaments give equal bytes.
std::string navigatorTournamentText(const NavigatorTournament& tournament);
std::string navigatorTournamentJson(const NavigatorTournament& tournament);
/// @}

}  // namespace fulbito
