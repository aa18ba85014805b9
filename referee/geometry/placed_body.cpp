#include "referee/geometry/placed_body.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kRounding = 1e-9;  // [m]

/// Half the body's extent along a unit vector.
double reachAlong(const PlacedBody& body, Vec2 direction) {
  return body.half_length * std::abs(dot(body.axis, direction)) +
         body.half_width * std::abs(cross(body.axis, direction));
}

}  // namespace

double PlacedBody::reachX() const { return reachAlong(*this, {1.0, 0.0}); }
double PlacedBody::reachY() const { return reachAlong(*this, {0.0, 1.0}); }

bool apart(const PlacedBody& a, const PlacedBody& b, double gap) {
  const Vec2 between = b.centre - a.centre;
  for (const Vec2 axis : {a.axis, perp(a.axis), b.axis, perp(b.axis)}) {
    if (std::abs(dot(between, axis)) >= reachAlong(a, axis) + reachAlong(b, axis) + gap) return true;
  }
  return false;
}

double distanceTo(const PlacedBody& body, Vec2 point) {
  const Vec2 local = intoFrame(body.axis, point - body.centre);
  return norm({std::max(0.0, std::abs(local.x) - body.half_length),
               std::max(0.0, std::abs(local.y) - body.half_width)});
}

bool onField(const FieldGeometry& field, const PlacedBody& body) {
  const Vec2 along = body.axis * body.half_length, across = perp(body.axis) * body.half_width;
  for (const Vec2 corner : {along + across, along - across, across - along, -along - across}) {
    if (!insideField(field, body.centre + corner, -kRounding)) return false;
  }
  if (!field.hasGoals()) return true;
  // Posts are the contour's only corners that point inward: a body may contain one with no corner outside.
  for (const double x : {-field.length / 2, field.length / 2}) {
    for (const double y : {-field.goal_width / 2, field.goal_width / 2}) {
      if (distanceTo(body, {x, y}) <= 0.0) return false;
    }
  }
  return true;
}

Vec2 clampedToField(const FieldGeometry& field, Vec2 p, double reach_x, double reach_y) {
  const double x = std::max(0.0, field.length / 2 - reach_x), y = std::max(0.0, field.width / 2 - reach_y);
  return {std::clamp(p.x, -x, x), std::clamp(p.y, -y, y)};
}

}  // namespace fulbito
