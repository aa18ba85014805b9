#include "strategies/teams/libero/situation/areas.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito::libero {

bool inOwnArea(const Pitch& pitch, Vec2 p, double margin) {
  const double depth = p.x + pitch.half_length;
  const double y = std::abs(p.y);
  if (depth < pitch.field.goal_area_depth + margin && y < pitch.area_half + margin) return true;
  return depth < pitch.field.goal_area_depth + pitch.field.goal_area_arc_depth + margin &&
         y < pitch.field.goal_area_arc_width / 2 + margin;
}

bool inTheirArea(const Pitch& pitch, Vec2 p, double margin) { return inOwnArea(pitch, -p, margin); }

Vec2 outOfOwnArea(const Pitch& pitch, Vec2 p, double margin) {
  if (!inOwnArea(pitch, p, margin)) return p;
  const double arc =
      std::abs(p.y) < pitch.field.goal_area_arc_width / 2 + margin ? pitch.field.goal_area_arc_depth : 0.0;
  const double front = -pitch.half_length + pitch.field.goal_area_depth + arc + margin;
  const double side = pitch.area_half + margin;
  if (side - std::abs(p.y) < front - p.x && side < pitch.half_width - pitch.robot_half) {
    return {p.x, std::copysign(side, p.y)};
  }
  return {front, p.y};
}

Vec2 outOfTheirArea(const Pitch& pitch, Vec2 p, double margin) { return -outOfOwnArea(pitch, -p, margin); }

double outsideOwnArea(const Pitch& pitch, Vec2 p) {
  const double ahead = p.x + pitch.half_length - pitch.field.goal_area_depth;
  const double aside = std::abs(p.y) - pitch.area_half;
  const double box =
      std::min(std::max(ahead, aside), 0.0) + norm({std::max(ahead, 0.0), std::max(aside, 0.0)});
  if (pitch.field.goal_area_arc_depth <= 0.0 || ahead <= 0.0) return box;
  const double rise = pitch.field.goal_area_arc_depth, half = pitch.field.goal_area_arc_width / 2;
  const double radius = (half * half + rise * rise) / (2 * rise);
  return std::min(box, norm({ahead + radius - rise, p.y}) - radius);
}

}  // namespace fulbito::libero
