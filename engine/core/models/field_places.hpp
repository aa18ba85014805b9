#pragma once

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {

/// `p` moved to where a body of half size `margin` [m] stays within the walls of the playing rectangle,
/// corner cuts included.
Vec2 insideWalls(const FieldGeometry& field, Vec2 p, double margin);

/// The place `depth` [m] before the goal line at -x that leaves the same gap on both sides of it, as `ball`
/// sees it: y = y_ball depth / (ball's distance to the goal line). A ball nearer to that line counts as
/// `depth` before it.
Vec2 equalGapPoint(const FieldGeometry& field, Vec2 ball, double depth);

}  // namespace fulbito
