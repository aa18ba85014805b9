// Private header of referee: not installed.
#pragma once

#include <optional>

#include "engine/core/base/vec2.hpp"
#include "engine/core/models/field_geometry.hpp"

namespace fulbito {

/// A rectangle on the field: a robot's body, or a marking.
struct PlacedBody {
  Vec2 centre;
  Vec2 axis{1.0, 0.0};  ///< unit, along the length
  double half_length = 0.0;
  double half_width = 0.0;

  double reachX() const;  ///< [m] from the centre to the farthest point along x
  double reachY() const;
};

/// Whether two bodies are at least `gap` [m] apart along one of their axes; then they do not overlap.
bool apart(const PlacedBody& a, const PlacedBody& b, double gap);
/// [m] from the body to a point outside; 0 for a point inside.
double distanceTo(const PlacedBody& body, Vec2 point);
/// Whether the whole body is on the field or in a goal.
bool onField(const FieldGeometry& field, const PlacedBody& body);
/// The point of the field nearest to `p` where a body of that reach may have its centre, roughly: corners and
/// goals are left to `onField`.
Vec2 clampedToField(const FieldGeometry& field, Vec2 p, double reach_x, double reach_y);

}  // namespace fulbito
