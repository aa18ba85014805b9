#pragma once

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {

/// Whether a point is in a goal area (arc included) that is wider by `margin` [m] on every side. `own`: the
/// area at -x of the team's frame.
bool isInArea(const FieldGeometry& field, Vec2 p, bool own, double margin = 0.0);

/// The nearest place to `p` outside that area: the last step before navigation for robots that have no
/// business there. A margin of 7 cm keeps every part of a 7.5 cm robot outside: its corners are 5.3 cm from
/// its centre. Points outside stay as they are.
Vec2 outsideArea(const FieldGeometry& field, Vec2 p, bool own, double margin);

/// [m] from that area to `p`, the arc as it is; negative inside.
double distanceToArea(const FieldGeometry& field, Vec2 p, bool own);

}  // namespace fulbito
