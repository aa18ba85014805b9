#include "engine/core/models/field_places.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {

Vec2 insideWalls(const FieldGeometry& field, Vec2 p, double margin) {
  const double x = field.length / 2 - margin, y = field.width / 2 - margin;
  p = {std::clamp(p.x, -x, x), std::clamp(p.y, -y, y)};
  // A corner cut is the line |x| + |y| = const; it lies `margin` farther in along its normal.
  const double beyond = std::abs(p.x) + std::abs(p.y) -
                        (field.length / 2 + field.width / 2 - field.corner - margin * std::sqrt(2.0));
  if (beyond > 0.0) p -= Vec2{std::copysign(beyond / 2, p.x), std::copysign(beyond / 2, p.y)};
  return p;
}

Vec2 equalGapPoint(const FieldGeometry& field, Vec2 ball, double depth) {
  const double goal_x = -field.length / 2;
  const double away = std::max(ball.x - goal_x, depth);
  return {goal_x + depth, ball.y * depth / away};
}

}  // namespace fulbito
