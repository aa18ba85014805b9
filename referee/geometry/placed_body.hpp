#pragma once

#include <optional>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// A rectangle on the field: a robot's body, or a marking.
struct PlacedBody {
  Vec2 centre;
  Vec2 axis{1.0, 0.0};  ///< unit, along the length
  double half_length = 0.0;
  double half_width = 0.0;

  double reachX() const;  ///< [m] half extent along x
  double reachY() const;
};

/// Whether two bodies are at least `gap` [m] apart along an axis of one of them. Then they do not overlap.
bool apart(const PlacedBody& a, const PlacedBody& b, double gap);
/// Distance [m] from the body to a point; 0 if it is inside.
double distanceTo(const PlacedBody& body, Vec2 point);
/// Whether the whole body is on the field or in a goal.
bool onField(const FieldGeometry& field, const PlacedBody& body);
/// `p` clamped to the centres that a body of that reach may have on the field. Ignores corners and goals,
/// which `onField` checks.
Vec2 clampedToField(const FieldGeometry& field, Vec2 p, double reach_x, double reach_y);

}  // namespace fulbito
