#pragma once

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// An area in front of a goal in that goal's frame: origin in the middle of the goal line, x into the field
/// (for both goals a rotation, no reflection). It has no end behind the goal line, so that a body in the goal
/// mouth is in the area.
struct AreaShape {
  double half_width = 0.0;  ///< [m] along the goal line; 0 = there is no such area
  double depth = 0.0;       ///< [m] depth of the straight part
  double arc_centre = 0.0;  ///< [m] x of the arc's centre; the area includes the circle beyond `depth`
  double arc_radius = 0.0;  ///< [m] 0 = no arc

  /// [m] how far the area reaches into the field.
  double reach() const { return arc_radius > 0.0 ? arc_centre + arc_radius : depth; }
};

/// @{ The areas of a field; without an arc where `arc` is false.
AreaShape goalAreaOf(const FieldGeometry& field, bool arc = true);
AreaShape bigAreaOf(const FieldGeometry& field);
/// @}

/// `area` with a border of `margin` [m] more on all sides.
AreaShape grown(const AreaShape& area, double margin);

/// @{ A point of the world in the frame of the goal at `side`, and back.
Vec2 intoGoalFrame(const FieldGeometry& field, Side side, Vec2 point);
Vec2 outOfGoalFrame(const FieldGeometry& field, Side side, Vec2 point);
/// @}

/// Whether a point is in the area or on its border.
bool contains(const AreaShape& area, Vec2 point);

/// Distance [m] from the area to a point in front of the goal line; inside, minus the distance to the border
/// of the straight part.
double distanceTo(const AreaShape& area, Vec2 point);

}  // namespace fulbito
