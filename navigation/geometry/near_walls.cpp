#include "navigation/geometry/near_walls.hpp"

#include <cmath>
#include <numbers>

namespace fulbito {

std::array<NearWall, 3> nearWalls(const FieldGeometry& field, Vec2 p, double post) {
  const double sx = std::copysign(1.0, p.x), sy = std::copysign(1.0, p.y);
  const double x = std::abs(p.x), y = std::abs(p.y), far = 1e9;
  const bool mouth = field.hasGoals() && y < field.goal_width / 2 - post;
  const bool inside_goal = mouth && x > field.length / 2;
  const double cut = (field.length / 2 + field.width / 2 - field.corner - x - y) / std::numbers::sqrt2;
  return {{{field.length / 2 + (mouth ? field.goal_depth : 0.0) - x, {-sx, 0.0}},
           {(inside_goal ? field.goal_width : field.width) / 2 - y, {0.0, -sy}},
           {field.corner > 0.0 && !inside_goal ? cut : far, Vec2{-sx, -sy} / std::numbers::sqrt2}}};
}

}  // namespace fulbito
