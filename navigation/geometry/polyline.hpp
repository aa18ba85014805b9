#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// Share (0 ... 1) of the way from `a` to `b` at which a point on it is nearest to `p`; 0 where they
/// coincide.
inline double nearestShare(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 edge = b - a;
  const double square = squaredNorm(edge);
  return square > 0.0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
}

/// Squared distance [m^2] from `p` to the segment from `a` to `b`.
inline double squaredDistanceToSegment(Vec2 a, Vec2 b, Vec2 p) {
  return squaredNorm(a + (b - a) * nearestShare(a, b, p) - p);
}

/// Distance [m] from `p` to a polyline; infinite with fewer than 2 points.
double distanceToPath(std::span<const Vec2> path, Vec2 p);

/// Length [m] of the polyline.
double polylineLength(std::span<const Vec2> path);

/// A place on a polyline.
struct PathPlace {
  std::size_t segment = 0;  ///< between points `segment` and `segment + 1`
  double fraction = 0.0;    ///< 0 ... 1 along that segment
};

/// The point at `place`.
Vec2 pointAt(std::span<const Vec2> path, PathPlace place);

/// The place `length` [m] further along; the last point if the path ends before.
PathPlace advance(std::span<const Vec2> path, PathPlace place, double length);

}  // namespace fulbito
