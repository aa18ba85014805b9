#pragma once

#include <span>

#include "navigation/methods/reactive/nearness_motion.hpp"
#include "navigation/obstacles/sector_scan.hpp"

namespace fulbito {

/// The part of the turn `wanted` [rad] that the body can make in place before one of its corners comes nearer
/// than `hull.margin` to an obstacle, or nearer than it already is. A rectangle in a gap a little wider than
/// itself swings its rear corners into what it has just passed.
double roomToTurn(std::span<const SectorHit> hits, const NearnessHull& hull, double wanted);

}  // namespace fulbito
