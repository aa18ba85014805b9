#pragma once

#include <array>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"

/// The second referee's own geometry. Nothing of `referee/` is used: areas are integrated slice by slice
/// instead of cut, so that a mistake of one is not a mistake of the other.
namespace fulbito::second {

/// A marked area in front of a goal: `u` [m] is the distance from the goal line into the field, `v` [m] along
/// the line from the goal's middle. Behind the goal line it has no end.
struct Marking {
  double half_width = 0.0;  ///< [m]; 0: no such area
  double depth = 0.0;       ///< [m]
  double arc_u = 0.0;       ///< [m] of the arc's centre, which is on the axis
  double arc_radius = 0.0;  ///< [m]; 0: no arc

  /// Half of its width [m] at this distance from the goal line.
  double halfWidthAt(double u) const;
  /// The same area with a border of `margin` [m] more.
  Marking widened(double margin) const;
};

Marking goalArea(const FieldGeometry& field, bool with_arc);
Marking bigArea(const FieldGeometry& field);

/// A point as (u, v) of the goal at this end: -1 the left one, +1 the right one.
Vec2 atEnd(const FieldGeometry& field, int end, Vec2 point);

/// The corners of a robot's body in the world, one after the other around it.
using Corners = std::array<Vec2, 4>;
Corners cornersOf(const Pose2& pose, double length, double width);

/// Whether the point is in the area or on its border.
bool isIn(const Marking& area, Vec2 uv);
/// Whether any part of the body, by its corners as (u, v), is in the area.
bool anyPartIn(const Marking& area, const Corners& uv);
/// The share of the body in the area, 0 ... 1, to about 1e-9.
double shareIn(const Marking& area, const Corners& uv);

/// Distance [m] between a body and a ball, negative where they overlap.
double gapBetween(const Pose2& pose, double length, double width, Vec2 ball, double radius);

}  // namespace fulbito::second
