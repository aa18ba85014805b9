#include "strategies/skills/area_projection.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

/// The circle whose segment bulges out of the area's front, in the frame of `Area`.
struct Arc {
  double centre = 0.0;  ///< [m] from the goal line
  double radius = 0.0;  ///< [m] 0: no arc
};

Arc arcOf(const FieldGeometry& field) {
  const double half = field.goal_area_arc_width / 2, depth = field.goal_area_arc_depth;
  if (half <= 0.0 || depth <= 0.0) return {};
  const double radius = (half * half + depth * depth) / (2.0 * depth);
  return {field.goal_area_depth + depth - radius, radius};
}

/// `p` seen from the goal line: x into the field, y aside.
Vec2 fromGoal(const FieldGeometry& field, Vec2 p, bool own) {
  return {field.length / 2 + (own ? p.x : -p.x), p.y};
}

}  // namespace

bool isInArea(const FieldGeometry& field, Vec2 p, bool own, double margin) {
  const Vec2 seen = fromGoal(field, p, own);
  const bool in_box =
      seen.x < field.goal_area_depth + margin && std::abs(seen.y) < field.goal_area_width / 2 + margin;
  if (in_box) return true;
  const Arc arc = arcOf(field);
  const double radius = arc.radius + margin;
  return arc.radius > 0.0 && seen.x > arc.centre &&
         squaredNorm(seen - Vec2{arc.centre, 0.0}) < radius * radius;
}

Vec2 outsideArea(const FieldGeometry& field, Vec2 p, bool own, double margin) {
  if (!isInArea(field, p, own, margin)) return p;
  const Vec2 seen = fromGoal(field, p, own);
  const double front = field.goal_area_depth + margin, side = field.goal_area_width / 2 + margin;
  const Arc arc = arcOf(field);
  double out = front;
  if (arc.radius > 0.0) {
    const double radius = arc.radius + margin;
    const double bulge2 = radius * radius - seen.y * seen.y;
    if (bulge2 > 0.0) out = std::max(out, arc.centre + std::sqrt(bulge2));
  }
  Vec2 place = seen;
  // Beside the area is out too, where a robot has room there.
  const double room = field.width / 2 - side;
  if (side - std::abs(seen.y) < out - seen.x && room > margin) {
    place.y = std::copysign(side, seen.y);
  } else {
    place.x = out;
  }
  const double x = place.x - field.length / 2;
  return {own ? x : -x, place.y};
}

}  // namespace fulbito
