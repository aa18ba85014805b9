#pragma once

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A path of constant curvature: a line, or an arc of a circle.
struct Arc {
  Pose2 start;             ///< pose at its beginning, heading along it
  double curvature = 0.0;  ///< [1/m] of its left turn; 0: a line; negative: it turns right
  double length = 0.0;     ///< [m] not negative

  double turn() const { return curvature * length; }  ///< [rad] change of heading over its length
};

/// The pose after `distance` [m] along the arc, which may be beyond its ends. Exact for any turn, however
/// small (Choi & Lee 2005, (8) and (9)).
Pose2 poseAt(const Arc& arc, double distance);

/// The end of the arc.
inline Pose2 endOf(const Arc& arc) { return poseAt(arc, arc.length); }

/// The arc from a pose, along its heading, through a point. It turns by less than a full circle. A point
/// straight behind has no such arc of finite length: the result is the line to it, with length infinity.
Arc arcThrough(const Pose2& start, Vec2 point);

}  // namespace fulbito
