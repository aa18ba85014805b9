#pragma once

#include <array>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A wall of the playing rectangle or of a corner triangle as an infinite line.
struct WallLine {
  Vec2 outward;            ///< unit normal away from the field
  double clearance = 0.0;  ///< [m] from the frame's origin to the wall, negative if the origin is beyond it
};

/// @{ The eight walls that `wallClearance` uses, in the frame of the field and in the frame of `pose`. The
/// field is where all clearances are positive. Without corner triangles their lines touch the corners.
std::array<WallLine, 8> wallLines(const FieldGeometry& field);
std::array<WallLine, 8> wallLines(const FieldGeometry& field, const Pose2& pose);
/// @}

}  // namespace fulbito
