#pragma once

#include "fulbito/detail/arc.hpp"

namespace fulbito {

/// Two arcs that meet at a point of inflection with a common tangent.
struct DoubleArc {
  Arc first;
  Arc second;

  double length() const { return first.length + second.length; }  ///< [m]
};

/// The two arcs between two poses, joined where the tangents at both ends are equally long. For equal
/// headings they are those of Choi & Lee (2005), Fig. 9: equal radii, joined halfway, each with half the
/// radius of the single arc to the joint. For a goal straight behind with the same heading there is no such
/// pair, and the length is infinite.
DoubleArc doubleArc(const Pose2& start, const Pose2& goal);

}  // namespace fulbito
