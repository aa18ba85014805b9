#pragma once

#include <span>

#include "navigation/obstacles/sector_scan.hpp"

namespace fulbito {

/// How a region wider than 90 degrees is entered.
enum class WideRegionRule {
  kCorner,  ///< past the border's obstacle point by atan2(R + d_s, its distance), at most to the middle
  kSector,  ///< 45 degrees inside the border
};

/// What the diagram shows at one tick, robot frame.
struct NearnessView {
  const SectorCircle* circle = nullptr;
  std::span<const SectorHit> hits;  ///< infinity where nothing lies within the diagram's range
  Vec2 goal;                        ///< [m]
  double radius = 0.0395;           ///< R [m]: a gap narrower than 2 R cannot be passed
  double security = 0.19;           ///< d_s [m]
  WideRegionRule wide_rule = WideRegionRule::kCorner;
};

/// The free walking area: the part of the circle through which the robot shall go.
struct WalkingArea {
  bool found = false;
  bool goal_inside = false;  ///< the goal itself can be reached; nothing below is set then
  int near_border = 0;       ///< s_rd: the area's sector at the open border that is nearest the goal
  int far_border = 0;        ///< s_od: its sector at the other end
  int inward = 1;            ///< +1 when the area lies clockwise of s_rd, else -1
  int width = 0;             ///< sectors
  Vec2 corner;               ///< [m] obstacle point just outside s_rd
};

/// Whether the area is wide: more than n / 4 sectors.
bool isWide(const NearnessView& view, const WalkingArea& area);

/// Direction [rad, robot frame] into an area without the goal: HSWR's when it is wide, else HSNR's
/// (s_rd + s_od) / 2.
double areaDirection(const NearnessView& view, const WalkingArea& area);

/// Navigability of `target` [m, robot frame]: obstacle points beside the way (0 <= x < its distance,
/// |y| <= 2 R) keep R from the target, and no point on the left is closer than 2 R to one on the right.
bool isNavigable(const NearnessView& view, Vec2 target);

/// Free walking area (Minguez & Montano 2004): the goal itself where it is visible and navigable; else walks
/// outwards from the goal's sector on both sides and takes the first region with an open border whose way in
/// is navigable. A border is a jump of more than 2 R between neighbouring sectors, open towards the farther
/// one. The way in is tried up to the range of the border's obstacle point in the direction that
/// `areaDirection` gives, so that what is tested is what is driven.
WalkingArea findWalkingArea(const NearnessView& view);

}  // namespace fulbito
