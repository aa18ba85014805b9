#include "navigation/methods/hybrid/room_to_turn.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kStep = 3.0 * math::kPi / 180.0;  // [rad] between the poses that are tried
constexpr double kSlack = 0.0006;                  // [m] what lies beside the axle hardly comes nearer
constexpr double kQuarter = math::kPi / 2;         // [rad] a body that turned so far has swept all

/// Distance from the body, turned by the angle of `ahead`, to the nearest point; at most the margin.
double clearance(std::span<const SectorHit> hits, const NearnessHull& hull, Vec2 ahead) {
  double least = hull.margin;
  for (const SectorHit& hit : hits) {
    if (hit.isEmpty()) continue;
    const Vec2 p = intoFrame(ahead, hit.point);
    least = std::min(least, std::max(std::abs(p.x) - hull.length / 2, std::abs(p.y) - hull.width / 2));
  }
  return least;
}

}  // namespace

double roomToTurn(std::span<const SectorHit> hits, const NearnessHull& hull, double wanted) {
  const double least = clearance(hits, hull, {1.0, 0.0}) - kSlack;
  const double most = std::min(std::abs(wanted), kQuarter), side = wanted < 0.0 ? -1.0 : 1.0;
  double free = 0.0;
  while (free < most) {
    const double next = std::min(most, free + kStep);
    if (clearance(hits, hull, math::unit(side * next)) < least) return side * free;
    free = next;
  }
  return wanted;
}

}  // namespace fulbito
