#pragma once

#include <cstddef>
#include <vector>

#include "fulbito/report.hpp"

namespace fulbito {

/// A path of lines and arcs, one after the other. A coordinate q [m] counts along all of them from the path's
/// beginning. Each part begins where the one before ends; headings may jump there, which is a corner.
class PartPath {
 public:
  PartPath() = default;
  explicit PartPath(std::vector<Arc> parts);

  const std::vector<Arc>& parts() const { return parts_; }
  std::size_t size() const { return parts_.size(); }
  double from(std::size_t part) const { return from_[part]; }    ///< coordinate of its beginning [m]
  double to(std::size_t part) const { return from_[part + 1]; }  ///< coordinate of its end [m]
  double length() const { return from_.back(); }                 ///< [m] of the whole path

  /// The part at q; at a joint the later one. Coordinates beyond the ends belong to the end parts.
  std::size_t partAt(double q) const;
  /// Pose at q on a part's line or circle, which goes on beyond the part's ends.
  Pose2 pose(std::size_t part, double q) const { return poseAt(parts_[part], q - from_[part]); }
  Pose2 pose(double q) const { return pose(partAt(q), q); }
  /// [rad] jump of the heading between a part and the next, in [-pi, pi).
  double jumpAfter(std::size_t part) const;
  /// Coordinate of the path's point nearest to `point`.
  double nearest(Vec2 point) const;

 private:
  std::vector<Arc> parts_;
  std::vector<double> from_{0.0};
};

/// Points along a path, at most `stride` [m] apart, in a frame whose origin is at `origin`.
std::vector<Vec2> pointsAlong(const PartPath& path, double stride, Vec2 origin = {});

/// Distance along `arc` of its point nearest to `point`, in [0, length].
double nearestOn(const Arc& arc, Vec2 point);

}  // namespace fulbito
