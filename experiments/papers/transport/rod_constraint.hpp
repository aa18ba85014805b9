#pragma once

#include <cstddef>

#include "experiments/papers/transport/part_path.hpp"

namespace fulbito {

/// A robot's place: a coordinate on one part's line or circle.
struct PartPlace {
  std::size_t part = 0;
  double q = 0.0;  ///< [m]
};

/// The rod relative to the tangents of both robots' parts. D is the vector from the follower to the lead. A
/// constant |D| requires (D t_lead) v_lead = (D t_follower) v_follower, whatever the parts are.
struct RodView {
  Vec2 rod;               ///< D [m]
  double lead = 0.0;      ///< [m] D along the lead's tangent
  double follower = 0.0;  ///< [m] D along the follower's tangent
};

RodView viewRod(const PartPath& path, const PartPlace& lead, const PartPlace& follower);

/// Speed of the slave [m/s] that keeps the rod's length: v_s = v_m (D t_m) / (D t_s). The corrected (4), (7)
/// and (10) of the paper are special cases. Infinite if the rod is perpendicular to the slave's direction.
double slaveSpeed(double master_speed, double along_master, double along_slave);

/// The slave's coordinate near `slave` at the distance `rod` from `other`: at most three Newton steps of at
/// most 5 mm each.
double onRod(const PartPath& path, Vec2 other, PartPlace slave, double rod);

}  // namespace fulbito
