#pragma once

#include <optional>
#include <span>

#include "navigation/methods/hybrid/occupancy_boxes.hpp"
#include "navigation/obstacles/sector_scan.hpp"

namespace fulbito {

/// The orbit that the limit cycle would drive round an obstacle ahead, robot frame.
struct FrontOrbit {
  FrontSection section;
  double radius = 0.0;  ///< [m] half of the section and the robot's size
};

/// When obstacles stand so densely that the nearness diagram is needed.
struct CrowdingRule {
  double radius = 0.053;     ///< R [m] of the robot
  double widest_gap = 0.19;  ///< [m] wider gaps between two obstacles are no narrow place
};

/// Whether the diagram, but for the quarter behind the robot, is crowded: it shows two obstacles with a gap
/// below `rule.widest_gap` between them, or one that the orbit round another would touch. Obstacles end where
/// a sector is empty or its distance jumps by more than 2 R.
/// @param orbit  round the obstacle ahead; empty: nothing is ahead
bool isCrowded(const SectorCircle& circle, std::span<const SectorHit> hits,
               const std::optional<FrontOrbit>& orbit, const CrowdingRule& rule);

}  // namespace fulbito
