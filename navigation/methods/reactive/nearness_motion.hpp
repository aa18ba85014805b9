#pragma once

#include "navigation/methods/reactive/nearness_area.hpp"

namespace fulbito {

/// The situations of the nearness diagram: HS = high safety (nothing in the security zone), LS = low safety.
enum class NearnessSituation {
  kHsgr,   ///< goal in the area
  kHswr,   ///< wide area
  kHsnr,   ///< narrow area
  kLs1,    ///< zone obstacles on one side of the way
  kLsgr,   ///< the same with the goal in the area
  kLs2,    ///< zone obstacles on both sides
  kStuck,  ///< no area: turn in place
};

/// The robot's rectangle and how much room it keeps.
struct NearnessHull {
  double length = 0.075;  ///< [m]
  double width = 0.075;   ///< [m]
  double margin = 0.01;   ///< [m]

  /// E [m]: from the centre to the hull in `direction` (unit vector, robot frame).
  double reach(Vec2 direction) const;
};

/// Share of d_s that is free on either side of a direction, 1 where nothing is in the zone.
struct SecurityZone {
  double left = 1.0;
  double right = 1.0;
  double nearest_bearing = 0.0;  ///< [rad] of the nearest zone obstacle

  double nearest() const { return left < right ? left : right; }
};

/// What the diagram decides, robot frame.
struct NearnessMotion {
  NearnessSituation situation = NearnessSituation::kStuck;
  double direction = 0.0;    ///< [rad] within +-pi/2
  double speed_share = 0.0;  ///< of the top speed: 1 in high safety, else what is free of d_s, at least 0.2
  bool blocked = false;      ///< emergency: something is right in front, no driving
  bool turn_cut = false;     ///< emergency: the turn was taken out, a rear corner would swing into something
};

/// Security zone left and right of `direction` [rad]. Obstacle points as far as `horizon` [m] count.
SecurityZone securityZone(const NearnessView& view, const NearnessHull& hull, double direction,
                          double horizon);

/// Direction [rad] in LS1 and LSGR: `wanted` weighted with the free share c of d_s, straight away from the
/// nearest obstacle with 1 - c.
double oneSidedDirection(double wanted, const SecurityZone& zone);

/// Direction [rad] in LS2: `wanted` turned toward the freer side by its excess (c_L - c_R) / (c_L + c_R).
double twoSidedDirection(double wanted, const SecurityZone& zone);

/// Distance [m] ahead of the robot's centre to the first point within `half_width` of its x axis; infinity
/// without one.
double roomAhead(std::span<const SectorHit> hits, double half_width);

/// The whole decision: area, situation, direction, speed, emergency.
///
/// Where the goal is in the area, obstacles that are farther than the goal are outside the zone (our
/// addition): otherwise a goal nearer than d_s to a wall is never reached.
NearnessMotion decideNearness(const NearnessView& view, const NearnessHull& hull);

}  // namespace fulbito
