#pragma once

#include <array>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A wall of the playing rectangle or of a corner triangle as an endless line.
struct WallLine {
  Vec2 outward;            ///< unit normal away from the field
  double clearance = 0.0;  ///< [m] of the frame's origin, negative beyond the wall
};

/// @{ The eight walls that `wallClearance` knows, seen from the field's centre and from `pose`. The field is
/// where all clearances are positive; without corner triangles their lines touch the corners.
std::array<WallLine, 8> wallLines(const FieldGeometry& field);
std::array<WallLine, 8> wallLines(const FieldGeometry& field, const Pose2& pose);
/// @}

}  // namespace fulbito
