#pragma once

#include <span>

#include "experiments/papers/transport/part_path.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// How a polyline becomes a path.
struct PathFit {
  double tolerance = 0.005;  ///< [m] largest distance of the path from the polyline, and of it from the path
  double corner = 0.7854;    ///< [rad] sharper vertices stay corners, where a robot turns in place
};

/// The two arcs that leave `from` along its heading, join with one tangent, and arrive at `to` along its
/// heading. Both have tangent legs of equal length. Arcs of length 0 are left out; a line is one arc.
std::vector<Arc> biarc(const Pose2& from, const Pose2& to);

/// Lines and arcs along a polyline, as few as greedy steps find: each biarc goes as far as the tolerance
/// permits. Where even a single segment is too long for a smooth bend, it is divided. Errors: kBadInput for
/// fewer than 2 points, points that are not finite, repeated ones, and a tolerance not above 0.1 mm.
Result<PartPath> fitPath(std::span<const Vec2> points, const PathFit& fit = {});

/// The largest distance [m] of points of the path from the polyline, and of its vertices from the path.
double distanceBetween(const PartPath& path, std::span<const Vec2> points);

}  // namespace fulbito
