#pragma once

#include <array>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// A wall's convex outline, counter-clockwise. The edge from the last point to the first faces the field.
using WallOutline = std::array<Vec2, 4>;

/// Solid walls around the field's inner contour, goals and corner triangles included, each
/// `field.wall_thickness` thick. In the field's corners they are mitred, so that no body can leave between
/// them; at the goal posts they overlap.
///
/// Where they overlap, the outer corner of the goal's wall lies in the face of the end wall. Contacts there
/// that push out of the field must be ignored (`pushesInward`), or sliding bodies would catch on that corner.
/// @param shift  [m] distance by which all inner faces move out of the field
std::vector<WallOutline> wallOutlines(const FieldGeometry& field, double shift);

/// Unit vector from a wall's inner face into the field.
Vec2 inward(const WallOutline& wall);
/// Whether a contact of a wall that faces along `inward` may push along the unit vector `normal`.
bool pushesInward(Vec2 inward, Vec2 normal);

}  // namespace fulbito
