#pragma once

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Half sizes [m] of a robot's rectangle. The clearances below are those of engine/core/models/shapes.hpp,
/// but take the body's direction as a unit vector. Planners call them thousands of times per second, and an
/// angle would cost a sine and a cosine each time.
struct BodyShape {
  double half_length = 0.0375;
  double half_width = 0.0375;

  double circumradius() const { return norm({half_length, half_width}); }  ///< [m]
};
BodyShape bodyShape(const RobotModel& robot);

/// Clearance [m] of the body at `position`, its x axis along the unit vector `along`, to a disc; negative
/// when they overlap.
double discClearance(const BodyShape& body, Vec2 position, Vec2 along, Vec2 centre, double radius);

/// Clearance [m] of the body to the nearest wall of the playing rectangle with its corner triangles.
double wallClearance(const BodyShape& body, Vec2 position, Vec2 along, const FieldGeometry& field);

}  // namespace fulbito
