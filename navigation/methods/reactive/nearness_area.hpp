#pragma once

#include <span>

#include "navigation/obstacles/sector_scan.hpp"

namespace fulbito {

/// How the robot enters a region wider than 90 degrees.
enum class WideRegionRule {
  kCorner,  ///< beside the border's obstacle point by atan2(R + d_s, its distance), at most in the middle
  kSector,  ///< 45 degrees inside the border
};

/// What the diagram shows in one tick, in the robot's frame.
struct NearnessView {
  const SectorCircle* circle = nullptr;
  std::span<const SectorHit> hits;  ///< infinite distance if nothing is within the diagram's range
  Vec2 goal;                        ///< [m]
  double radius = 0.0395;           ///< R [m]: the robot cannot pass a gap narrower than 2 R
  double security = 0.19;           ///< d_s [m]
  WideRegionRule wide_rule = WideRegionRule::kCorner;
};

/// The free walking area: the part of the circle through which the robot should go.
struct WalkingArea {
  bool found = false;
  bool goal_inside = false;  ///< the robot can reach the goal itself; the members below are then not set
  int near_border = 0;       ///< s_rd: the area's sector at the open border nearest to the goal
  int far_border = 0;        ///< s_od: the area's sector at the other end
  int inward = 1;            ///< +1 if the area is clockwise from s_rd, else -1
  int width = 0;             ///< number of sectors
  Vec2 corner;               ///< [m] obstacle point just outside s_rd
};

/// Whether the area is wide: more than n / 4 sectors.
bool isWide(const NearnessView& view, const WalkingArea& area);

/// Direction [rad, robot frame] into an area without the goal: that of HSWR if the area is wide, else (s_rd +
/// s_od) / 2 of HSNR.
double areaDirection(const NearnessView& view, const WalkingArea& area);

/// Whether the robot can reach `target` [m, robot frame]: obstacle points beside the way (0 <= x < its
/// distance, |y| <= 2 R) are at least R from the target. No point on the left is closer than 2 R to one on
/// the right.
bool isNavigable(const NearnessView& view, Vec2 target);

/// Free walking area (Minguez & Montano 2004): the goal itself if it is visible and reachable. Otherwise it
/// searches outward from the goal's sector on both sides and takes the first region whose open border has a
/// navigable way in. A border is a jump of more than 2 R between neighbouring sectors, open toward the
/// farther one. The tested way in has the range of the border's obstacle point and the direction of
/// `areaDirection`, which is also the direction to drive.
WalkingArea findWalkingArea(const NearnessView& view);

}  // namespace fulbito
