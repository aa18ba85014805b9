#pragma once

#include "navigation/methods/reactive/nearness_area.hpp"

namespace fulbito {

/// Situations of the nearness diagram: HS = high safety (security zone empty), LS = low safety.
enum class NearnessSituation {
  kHsgr,   ///< goal in the area
  kHswr,   ///< wide area
  kHsnr,   ///< narrow area
  kLs1,    ///< obstacles in the zone on one side of the direction
  kLsgr,   ///< the same as kLs1 with the goal in the area
  kLs2,    ///< obstacles in the zone on both sides
  kStuck,  ///< no area: turn in place
};

/// The robot's rectangle and the gap that it keeps.
struct NearnessHull {
  double length = 0.075;  ///< [m]
  double width = 0.075;   ///< [m]
  double margin = 0.01;   ///< [m]

  /// E [m]: distance from the centre to the hull in `direction` (unit vector, robot frame).
  double reach(Vec2 direction) const;
};

/// Free share of d_s on each side of a direction; 1 if the zone is empty.
struct SecurityZone {
  double left = 1.0;
  double right = 1.0;
  double nearest_bearing = 0.0;  ///< [rad] of the nearest obstacle in the zone

  double nearest() const { return left < right ? left : right; }
};

/// The diagram's decision, in the robot's frame.
struct NearnessMotion {
  NearnessSituation situation = NearnessSituation::kStuck;
  double direction = 0.0;    ///< [rad] within +-pi/2
  double speed_share = 0.0;  ///< share of the top speed; less in low safety, at least 0.2
  bool blocked = false;      ///< emergency: something is right in front, and the robot must not drive
  bool turn_cut = false;     ///< emergency: no turn, since a rear corner would swing into something
};

/// Security zone on the left and right of `direction` [rad]. Obstacle points beyond `horizon` [m] do not
/// count.
SecurityZone securityZone(const NearnessView& view, const NearnessHull& hull, double direction,
                          double horizon);

/// Direction [rad] in LS1 and LSGR: `wanted` with the weight of the free share c of d_s, and the direction
/// away from the nearest obstacle with 1 - c.
double oneSidedDirection(double wanted, const SecurityZone& zone);

/// Direction [rad] in LS2: `wanted` turned toward the freer side in proportion to (c_L - c_R) / (c_L + c_R).
double twoSidedDirection(double wanted, const SecurityZone& zone);

/// Distance [m] from the robot's centre to the first point ahead within `half_width` [m] of its x axis;
/// infinite if there is none.
double roomAhead(std::span<const SectorHit> hits, double half_width);

/// The complete decision: area, situation, direction, speed and emergency rules.
///
/// If the goal is in the area, obstacles farther away than the goal are outside the zone. This is not in the
/// paper; without it the robot would never reach a goal nearer than d_s to a wall.
NearnessMotion decideNearness(const NearnessView& view, const NearnessHull& hull);

}  // namespace fulbito
