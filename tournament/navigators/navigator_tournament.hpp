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
  std::vector<std::string> navigators;  ///< specifications, each once; empty: all built-in ones
  std::optional<double> speed;          ///< [m/s] top speed; empty: the first of the suite
  int trials = 0;                       ///< layouts; 0: the suite's
  std::uint64_t seed = 2015;            ///< of layouts, sensor noise and resamples
  int jobs = 0;                         ///< worker threads; 0: all cores
  std::string robot = "jung-lee-2015";  ///< preset or file
  std::string physics = "standard";     ///< preset or file
  SensorModel sensors;                  ///< quality of observations
};

/// A tournament that has been played.
struct NavigatorTournament {
  Comparison comparison;  ///< of one block, with the records of all trials
  double tie = 0.0;       ///< [s] difference of times up to which a layout is drawn: a control tick
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
