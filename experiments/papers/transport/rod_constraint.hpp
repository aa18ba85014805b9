#pragma once

#include <cstddef>

#include "experiments/papers/transport/part_path.hpp"

namespace fulbito {

/// A robot's place: a coordinate on one part's line or circle.
struct PartPlace {
  std::size_t part = 0;
  double q = 0.0;  ///< [m]
};

/// The rod seen from the tangents of both robots' parts. With D from the follower to the lead, |D| constant
/// demands (D t_lead) v_lead = (D t_follower) v_follower, whatever the parts are.
struct RodView {
  Vec2 rod;               ///< D [m]
  double lead = 0.0;      ///< [m] D along the lead's tangent
  double follower = 0.0;  ///< [m] D along the follower's tangent
};

RodView viewRod(const PartPath& path, const PartPlace& lead, const PartPlace& follower);

/// Speed of the slave [m/s] that keeps the rod's length: v_s = v_m (D t_m) / (D t_s). (4) corrected, (7) and
/// (10) of the paper are its cases. Infinite where the rod is across the slave's way.
double slaveSpeed(double master_speed, double along_master, double along_slave);

/// The slave's coordinate near `slave` at which it is `rod` away from `other`: at most three of Newton's
/// steps, each of at most 5 mm.
double onRod(const PartPath& path, Vec2 other, PartPlace slave, double rod);

}  // namespace fulbito
