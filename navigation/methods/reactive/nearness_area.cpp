#include "navigation/methods/reactive/nearness_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

const SectorHit& hitOf(const NearnessView& view, int sector) {
  return view.hits[static_cast<std::size_t>(view.circle->wrap(sector))];
}

/// Whether the distance jumps by more than 2 R from sector `from` to its deeper neighbour `to`. The infinite
/// distance of an empty sector is deeper than any other.
bool opensInto(const NearnessView& view, int from, int to) {
  return hitOf(view, to).distance > hitOf(view, from).distance + 2.0 * view.radius;
}

bool isBorder(const NearnessView& view, int a, int b) {
  return opensInto(view, a, b) || opensInto(view, b, a);
}

WalkingArea areaFrom(const NearnessView& view, int border, int inward) {
  WalkingArea area;
  area.near_border = view.circle->wrap(border);
  area.inward = inward;
  area.corner = hitOf(view, border - inward).point;
  int last = border;
  area.width = 1;
  while (area.width < view.circle->count() && !isBorder(view, last, last + inward)) {
    last += inward;
    ++area.width;
  }
  area.far_border = view.circle->wrap(last);
  return area;
}

bool isGoalReachable(const NearnessView& view) {
  const double range = norm(view.goal);
  const int sector = view.circle->sectorOf(math::angleOf(view.goal));
  return hitOf(view, sector).distance >= range && isNavigable(view, view.goal);
}

}  // namespace

bool isWide(const NearnessView& view, const WalkingArea& area) {
  return 4 * area.width > view.circle->count();
}

double areaDirection(const NearnessView& view, const WalkingArea& area) {
  const double step = view.circle->step();
  double turn = step * (area.width - 1) / 2;  // to the middle of the area
  if (isWide(view, area)) {
    const bool by_corner = view.wide_rule == WideRegionRule::kCorner;
    turn = std::min(turn,
                    by_corner ? math::atan2(view.radius + view.security, norm(area.corner)) : math::kPi / 4);
  }
  // Sector numbers grow clockwise, bearings counter-clockwise.
  return math::wrapAngle(view.circle->bearing(area.near_border) - area.inward * turn);
}

bool isNavigable(const NearnessView& view, Vec2 target) {
  const double range = norm(target), width = 2.0 * view.radius;
  const Vec2 along = unitOr(target, {1.0, 0.0});
  std::array<Vec2, kMaxSectors> left, right;
  std::size_t lefts = 0, rights = 0;
  for (const SectorHit& hit : view.hits) {
    const double x = dot(along, hit.point), y = cross(along, hit.point);
    if (hit.isEmpty() || x < 0.0 || x >= range || std::abs(y) > width) continue;
    if (distance(hit.point, target) < view.radius) return false;
    if (y >= 0.0) {
      left[lefts++] = hit.point;
    } else {
      right[rights++] = hit.point;
    }
  }
  for (std::size_t i = 0; i < lefts; ++i) {
    for (std::size_t j = 0; j < rights; ++j) {
      if (squaredNorm(left[i] - right[j]) < width * width) return false;
    }
  }
  return true;
}

WalkingArea findWalkingArea(const NearnessView& view) {
  if (isGoalReachable(view)) {
    WalkingArea to_goal;
    to_goal.found = to_goal.goal_inside = true;
    return to_goal;
  }
  const double bearing = math::angleOf(view.goal);
  const int goal_sector = view.circle->sectorOf(bearing);
  // If two borders are equally far from the goal's sector, take the one on the goal's side of its bisector.
  const int nearer = math::wrapAngle(bearing - view.circle->bearing(goal_sector)) >= 0.0 ? -1 : 1;
  for (int offset = 0; offset <= view.circle->count() / 2; ++offset) {
    for (int side : {nearer, -nearer}) {
      const int sector = goal_sector + side * offset;
      for (int inward : {side, -side}) {
        if (!opensInto(view, sector - inward, sector)) continue;
        WalkingArea area = areaFrom(view, sector, inward);
        const Vec2 way_in = math::unit(areaDirection(view, area)) * norm(area.corner);
        area.found = isNavigable(view, way_in);
        if (area.found) return area;
      }
    }
  }
  return {};
}

}  // namespace fulbito
