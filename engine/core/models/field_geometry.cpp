#include "fulbito/detail/field_geometry.hpp"

#include <cmath>
#include <limits>

namespace fulbito {
namespace {

struct NearestWall {
  double clearance;
  Vec2 normal;
};

NearestWall nearestWall(const FieldGeometry& field, Vec2 p) {
  const double sx = p.x < 0.0 ? -1.0 : 1.0;
  const double sy = p.y < 0.0 ? -1.0 : 1.0;
  NearestWall best{field.length / 2 - sx * p.x, {-sx, 0.0}};
  const double to_side = field.width / 2 - sy * p.y;
  if (to_side < best.clearance) best = {to_side, {0.0, -sy}};
  if (field.corner > 0.0) {
    const double cut =
        (field.length / 2 + field.width / 2 - field.corner - sx * p.x - sy * p.y) / std::sqrt(2.0);
    if (cut < best.clearance) best = {cut, Vec2{-sx, -sy} / std::sqrt(2.0)};
  }
  return best;
}

}  // namespace

FieldGeometry plainFloor(const std::string& name, double length, double width) {
  FieldGeometry field;
  field.name = name;
  field.length = length;
  field.width = width;
  field.goal_width = field.goal_depth = field.corner = 0.0;
  field.goal_area_width = field.goal_area_depth = field.goal_area_arc_width = field.goal_area_arc_depth = 0.0;
  field.centre_circle_radius = field.penalty_mark = 0.0;
  field.free_ball_mark = {};
  return field;
}

std::vector<Vec2> innerContour(const FieldGeometry& field) {
  const double x = field.length / 2, y = field.width / 2, c = field.corner;
  const double g = field.goal_width / 2, d = field.goal_depth;
  std::vector<Vec2> half;  // right half, from the bottom to the top
  if (c > 0.0) {
    half = {{x - c, -y}, {x, -y + c}};
  } else {
    half = {{x, -y}};
  }
  if (field.hasGoals()) {
    for (Vec2 p : {Vec2{x, -g}, Vec2{x + d, -g}, Vec2{x + d, g}, Vec2{x, g}}) half.push_back(p);
  }
  if (c > 0.0) {
    half.push_back({x, y - c});
    half.push_back({x - c, y});
  } else {
    half.push_back({x, y});
  }
  std::vector<Vec2> contour = half;
  for (Vec2 p : half) contour.push_back(-p);  // the field is symmetric under a half turn
  return contour;
}

double wallClearance(const FieldGeometry& field, Vec2 p) {
  if (!isFinite(p)) return -std::numeric_limits<double>::infinity();
  return nearestWall(field, p).clearance;
}

Vec2 nearestWallNormal(const FieldGeometry& field, Vec2 p) { return nearestWall(field, p).normal; }

bool insideField(const FieldGeometry& field, Vec2 p, double margin) {
  if (wallClearance(field, p) >= margin) return true;
  return field.hasGoals() && std::abs(p.y) <= field.goal_width / 2 - margin &&
         std::abs(p.x) <= field.length / 2 + field.goal_depth - margin;
}

}  // namespace fulbito
