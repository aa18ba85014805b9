#pragma once

#include <array>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A wall near a point.
struct NearWall {
  double gap = 0.0;  ///< [m] from the point to the wall, negative beyond
  Vec2 inward;       ///< unit normal into the field
};

/// The end wall, side wall and corner triangle, in this order, of the quarter of the field that holds `p`. In
/// a goal, and in front of it more than `post` [m] from its posts, the end wall is the goal's back wall.
std::array<NearWall, 3> nearWalls(const FieldGeometry& field, Vec2 p, double post);

}  // namespace fulbito
