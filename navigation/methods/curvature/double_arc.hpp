#pragma once

#include "fulbito/detail/arc.hpp"

namespace fulbito {

/// Two arcs that meet with one tangent at a point of inflection.
struct DoubleArc {
  Arc first;
  Arc second;

  double length() const { return first.length + second.length; }  ///< [m]
};

/// The two arcs from a pose to a pose, joined where the tangents at both ends are equally long. For equal
/// headings they are those of Choi & Lee (2005), Fig. 9: equal radii, joined halfway, each with half the
/// radius of the single arc to that place. For a goal straight behind with the same heading there are none:
/// then the length is infinite.
DoubleArc doubleArc(const Pose2& start, const Pose2& goal);

}  // namespace fulbito
