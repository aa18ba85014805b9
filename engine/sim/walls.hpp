// Private header of engine/sim: not installed.
#pragma once

#include <array>
#include <vector>

#include "engine/core/field_geometry.hpp"
#include "engine/core/vec2.hpp"

namespace fulbito {

/// A wall's outline, counter-clockwise and convex; its first edge faces the field.
using WallOutline = std::array<Vec2, 4>;

/// Solid walls around the field's inner contour, goals and corner triangles included, each
/// `field.wall_thickness` thick. Where two meet in a corner of the field they are mitred, so that nothing can
/// leave between them; at the goal posts they overlap.
/// @param shift  [m] all inner faces are moved out of the field by this
std::vector<WallOutline> wallOutlines(const FieldGeometry& field, double shift);

}  // namespace fulbito
