#include "engine/core/models/goal_area.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {

AreaShape goalAreaOf(const FieldGeometry& field, bool arc) {
  AreaShape area{field.goal_area_width / 2, field.goal_area_depth, 0.0, 0.0};
  if (!arc || field.goal_area_arc_depth <= 0.0 || field.goal_area_arc_width <= 0.0) return area;
  const double half = field.goal_area_arc_width / 2, rise = field.goal_area_arc_depth;
  area.arc_radius = (half * half + rise * rise) / (2 * rise);
  area.arc_centre = area.depth + rise - area.arc_radius;
  return area;
}

AreaShape bigAreaOf(const FieldGeometry& field) {
  return {field.big_area_width / 2, field.big_area_depth, 0.0, 0.0};
}

AreaShape grown(const AreaShape& area, double margin) {
  AreaShape more = area;
  if (more.half_width > 0.0) more.half_width += margin, more.depth += margin;
  if (more.arc_radius > 0.0) more.arc_radius += margin;
  return more;
}

Vec2 intoGoalFrame(const FieldGeometry& field, Side side, Vec2 point) {
  const double middle = field.length / 2;
  return side == Side::kLeft ? Vec2{point.x + middle, point.y} : Vec2{middle - point.x, -point.y};
}

Vec2 outOfGoalFrame(const FieldGeometry& field, Side side, Vec2 point) {
  const double middle = field.length / 2;
  return side == Side::kLeft ? Vec2{point.x - middle, point.y} : Vec2{middle - point.x, -point.y};
}

bool contains(const AreaShape& area, Vec2 point) {
  if (point.x <= area.depth) return area.half_width > 0.0 && std::abs(point.y) <= area.half_width;
  return squaredNorm(point - Vec2{area.arc_centre, 0.0}) <= area.arc_radius * area.arc_radius;
}

double distanceTo(const AreaShape& area, Vec2 point) {
  const double ahead = point.x - area.depth, aside = std::abs(point.y) - area.half_width;
  const double box =
      std::min(std::max(ahead, aside), 0.0) + norm({std::max(ahead, 0.0), std::max(aside, 0.0)});
  if (area.arc_radius <= 0.0 || ahead <= 0.0) return box;
  return std::min(box, norm({point.x - area.arc_centre, point.y}) - area.arc_radius);
}

}  // namespace fulbito
