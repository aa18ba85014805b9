#pragma once

#include <string>

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {

/// A rectangular floor between four walls: no goals, no corner triangles, no marks of soccer.
/// @param length, width  [m]
FieldGeometry plainFloor(const std::string& name, double length, double width);

}  // namespace fulbito
