#include "navigation/geometry/polyline.hpp"

#include <limits>

namespace fulbito {

double distanceToPath(std::span<const Vec2> path, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i) {
    least = std::min(least, squaredDistanceToSegment(path[i - 1], path[i], p));
  }
  return std::sqrt(least);
}

double polylineLength(std::span<const Vec2> path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
  return length;
}

Vec2 pointAt(std::span<const Vec2> path, PathPlace place) {
  if (path.size() == 1) return path.front();
  return path[place.segment] + (path[place.segment + 1] - path[place.segment]) * place.fraction;
}

PathPlace advance(std::span<const Vec2> path, PathPlace place, double length) {
  std::size_t segment = place.segment;
  double from = place.fraction;
  for (; segment + 1 < path.size(); ++segment, from = 0.0) {
    const double edge = distance(path[segment], path[segment + 1]);
    const double left = (1.0 - from) * edge;
    if (length <= left) return {segment, edge > 0.0 ? from + length / edge : from};
    length -= left;
  }
  return {path.size() >= 2 ? path.size() - 2 : 0, 1.0};
}

}  // namespace fulbito
