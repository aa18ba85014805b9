#pragma once

#include <cstddef>
#include <vector>

#include "fulbito/report.hpp"

namespace fulbito {

/// A path of successive lines and arcs. A coordinate q [m] is the length along the path from its beginning.
/// Each part begins where the one before ends. The heading may jump there, which is a corner.
class PartPath {
 public:
  PartPath() = default;
  explicit PartPath(std::vector<Arc> parts);

  const std::vector<Arc>& parts() const { return parts_; }
  std::size_t size() const { return parts_.size(); }
  double from(std::size_t part) const { return from_[part]; }    ///< [m] coordinate of the part's beginning
  double to(std::size_t part) const { return from_[part + 1]; }  ///< [m] coordinate of the part's end
  double length() const { return from_.back(); }                 ///< [m] of the whole path

  /// The part at q; at a joint, the later part. Coordinates beyond the ends belong to the first or last part.
  std::size_t partAt(double q) const;
  /// Pose at q on a part's line or circle, which continues beyond the part's ends.
  Pose2 pose(std::size_t part, double q) const { return poseAt(parts_[part], q - from_[part]); }
  Pose2 pose(double q) const { return pose(partAt(q), q); }
  /// Jump [rad] of the heading between a part and the next, in [-pi, pi).
  double jumpAfter(std::size_t part) const;
  /// Coordinate of the point of the path nearest to `point`.
  double nearest(Vec2 point) const;

 private:
  std::vector<Arc> parts_;
  std::vector<double> from_{0.0};
};

/// Points along a path, at most `stride` [m] apart, relative to `origin`.
std::vector<Vec2> pointsAlong(const PartPath& path, double stride, Vec2 origin = {});

/// Distance along `arc` to its point nearest to `point`, in [0, length].
double nearestOn(const Arc& arc, Vec2 point);

}  // namespace fulbito
