#pragma once

#include <string>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Six robots that drive from goal to goal on one field, as moving obstacles to each other. Measures the cost
/// of navigation in play.
struct CrowdConfig {
  std::string navigator = kDefaultNavigator;  ///< specification
  std::string robot = "vsss";                 ///< preset or file
  double seconds = 60.0;                      ///< simulated time, > 0
  std::uint64_t seed = 2015;
};

struct CrowdResult {
  int arrivals = 0;              ///< goals reached by all robots together
  int contacts = 0;              ///< number of contacts between robots, or of robots with walls
  double compute_us_mean = 0.0;  ///< mean time of navigator and follower, per robot and tick
  double compute_us_p99 = 0.0;
  double compute_us_max = 0.0;
};

/// Runs the crowd. Errors: kUsage, kIo, kBadInput for the names.
Result<CrowdResult> runCrowd(const CrowdConfig& config, const Clock& clock);

}  // namespace fulbito
