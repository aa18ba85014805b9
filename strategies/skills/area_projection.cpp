#include "strategies/skills/area_projection.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/goal_area.hpp"

namespace fulbito {
namespace {

Side sideOf(bool own) { return own ? Side::kLeft : Side::kRight; }

/// Whether a point of the goal's frame is at least `margin` [m] farther from the goal line than any point of
/// the goal area. Most points are, and this takes less time than the area's shape.
bool isBeyond(const FieldGeometry& field, Vec2 seen, double margin) {
  constexpr double kRounding = 1e-9;  // [m]
  return seen.x > field.goal_area_depth + std::max(0.0, field.goal_area_arc_depth) + margin + kRounding;
}

}  // namespace

bool isInArea(const FieldGeometry& field, Vec2 p, bool own, double margin) {
  const Vec2 seen = intoGoalFrame(field, sideOf(own), p);
  return !isBeyond(field, seen, margin) && contains(grown(goalAreaOf(field), margin), seen);
}

Vec2 outsideArea(const FieldGeometry& field, Vec2 p, bool own, double margin) {
  const Vec2 seen = intoGoalFrame(field, sideOf(own), p);
  if (isBeyond(field, seen, margin)) return p;
  const AreaShape area = grown(goalAreaOf(field), margin);
  if (!contains(area, seen)) return p;
  double out = area.depth;
  const double bulge2 = area.arc_radius * area.arc_radius - seen.y * seen.y;
  if (area.arc_radius > 0.0 && bulge2 > 0.0) out = std::max(out, area.arc_centre + std::sqrt(bulge2));
  Vec2 place{out, seen.y};
  // The place beside the area is nearer, and a robot fits between the area and the side wall.
  const double room = field.width / 2 - area.half_width;
  if (area.half_width - std::abs(seen.y) < out - seen.x && room > margin) {
    place = {seen.x, std::copysign(area.half_width, seen.y)};
  }
  return outOfGoalFrame(field, sideOf(own), place);
}

double distanceToArea(const FieldGeometry& field, Vec2 p, bool own) {
  return distanceTo(goalAreaOf(field), intoGoalFrame(field, sideOf(own), p));
}

bool isNearArea(const FieldGeometry& field, Vec2 p, bool own, double distance) {
  const Vec2 seen = intoGoalFrame(field, sideOf(own), p);
  return !isBeyond(field, seen, distance) && distanceToArea(field, p, own) < distance;
}

}  // namespace fulbito
