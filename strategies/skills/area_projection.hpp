#pragma once

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {

/// Whether a point is in a goal area (arc included) enlarged by `margin` [m] on each side. `own`: the area at
/// -x of the team's frame.
bool isInArea(const FieldGeometry& field, Vec2 p, bool own, double margin = 0.0);

/// The point outside that area that is nearest to `p`; `p` itself if it is outside. Teams apply it last,
/// before navigation, to the target of a robot that must not enter. A margin of 7 cm keeps all parts of a 7.5
/// cm robot outside: its corners are 5.3 cm from its centre.
Vec2 outsideArea(const FieldGeometry& field, Vec2 p, bool own, double margin);

/// Distance [m] from that area (arc included, without a margin) to `p`; negative inside.
double distanceToArea(const FieldGeometry& field, Vec2 p, bool own);

/// Whether a point is in that area (arc included) or less than `distance` [m] away from it.
bool isNearArea(const FieldGeometry& field, Vec2 p, bool own, double distance);

}  // namespace fulbito
