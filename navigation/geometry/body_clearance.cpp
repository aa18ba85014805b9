#include "navigation/geometry/body_clearance.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {

BodyShape bodyShape(const RobotModel& robot) { return {robot.length / 2, robot.width / 2}; }

double discClearance(const BodyShape& body, Vec2 position, Vec2 along, Vec2 centre, double radius) {
  const Vec2 d = centre - position;
  const double x = std::abs(dot(d, along)) - body.half_length;
  const double y = std::abs(cross(along, d)) - body.half_width;
  if (x > 0.0 && y > 0.0) return std::sqrt(x * x + y * y) - radius;
  return std::max(x, y) - radius;
}

double wallClearance(const BodyShape& body, Vec2 position, Vec2 along, const FieldGeometry& field) {
  const double x = std::abs(position.x), y = std::abs(position.y);
  const double tx = std::abs(along.x), ty = std::abs(along.y);
  const double to_end = field.length / 2 - x - body.half_length * tx - body.half_width * ty;
  const double to_side = field.width / 2 - y - body.half_length * ty - body.half_width * tx;
  const double least = std::min(to_end, to_side);
  if (field.corner <= 0.0) return least;
  const double half_root = 0.70710678118654752;
  // The corner's face has the normal (1, 1) in the quadrant of the position.
  const double same = position.x * position.y * along.x * along.y >= 0.0 ? 1.0 : -1.0;
  const double ahead = std::abs(tx + same * ty), across = std::abs(tx - same * ty);
  const double to_corner = half_root * (field.length / 2 + field.width / 2 - field.corner - x - y -
                                        body.half_length * ahead - body.half_width * across);
  return std::min(least, to_corner);
}

}  // namespace fulbito
