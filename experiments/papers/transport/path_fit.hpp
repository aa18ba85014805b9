#pragma once

#include <span>

#include "experiments/papers/transport/part_path.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Settings for the conversion of a polyline to a path.
struct PathFit {
  double tolerance = 0.005;  ///< [m] greatest distance between path and polyline, both ways
  double corner = 0.7854;    ///< [rad] sharper vertices remain corners, at which a robot turns in place
};

/// The two arcs that leave `from` along its heading, meet with a common tangent, and arrive at `to` along its
/// heading. Both have equal tangent legs. Arcs of length 0 are left out; a line is one arc.
std::vector<Arc> biarc(const Pose2& from, const Pose2& to);

/// Lines and arcs along a polyline. A greedy search makes each biarc as long as the tolerance permits.
/// Segments that are too long for a smooth bend are divided. Errors: kBadInput for fewer than 2 points,
/// points that are not finite or repeated, and a tolerance that is not above 0.1 mm.
Result<PartPath> fitPath(std::span<const Vec2> points, const PathFit& fit = {});

/// The largest distance [m] of points of the path from the polyline and of the polyline's vertices from the
/// path.
double distanceBetween(const PartPath& path, std::span<const Vec2> points);

}  // namespace fulbito
