#pragma once

#include <cstdint>

#include "experiments/papers/transport/transport_task.hpp"

namespace fulbito {

/// A task on a random path: 5 to 14 lines of 0.2 to 1.5 m and arcs of radius 0.15 to 0.6 m by 30 to 240
/// degrees. One joint in six is a corner of 15 to 135 degrees. The rod is 0.3 to 1 m long. The task may be
/// infeasible.
///
/// @param index  number of the path
TransportTask randomTransport(std::uint64_t seed, std::uint64_t index);

}  // namespace fulbito
