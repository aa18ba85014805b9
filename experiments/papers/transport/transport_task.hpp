#pragma once

#include "experiments/papers/transport/part_path.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Two robots carry a rod along a path, each at one of its ends (Lee, Lee & Lee, section II). The defaults
/// are the paper's settings for its S path.
struct TransportTask {
  PartPath path;
  double rod = 0.80;        ///< [m] between the robots' centres
  double speed = 0.08;      ///< [m/s] speed of the master
  double max_speed = 0.10;  ///< [m/s] greatest speed of either robot
  double lead = 0.80;       ///< [m] start of the leading robot along the path
  double follower = 0.0;    ///< [m] start of the following robot
};

/// The smallest coordinate beyond `from` whose point is `rod` [m] away from the path's point at `from`.
/// Errors: kBadInput if there is none.
Result<double> rodLengthAhead(const PartPath& path, double from, double rod);

}  // namespace fulbito
