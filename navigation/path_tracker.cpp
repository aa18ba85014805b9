#include "navigation/path_tracker.hpp"

#include <algorithm>

namespace fulbito {
namespace {

constexpr double kWindowAhead = 0.25;  // [m] searched ahead of the last place

}  // namespace

PathPlace PathTracker::locate(std::span<const Vec2> path, std::uint64_t revision, Vec2 p) {
  const bool fresh = !known_ || revision != revision_ || place_.segment + 1 >= path.size();
  const std::size_t begin = fresh ? 0 : place_.segment;
  PathPlace best{begin, 0.0};
  double best_distance = 1e300, travelled = 0.0;
  for (std::size_t i = begin; i + 1 < path.size(); ++i) {
    const Vec2 edge = path[i + 1] - path[i];
    const double square = squaredNorm(edge);
    const double fraction = square > 0.0 ? std::clamp(dot(p - path[i], edge) / square, 0.0, 1.0) : 0.0;
    const double d = squaredNorm(path[i] + edge * fraction - p);
    if (d < best_distance) best_distance = d, best = {i, fraction};
    if (!fresh && i > begin) travelled += std::sqrt(square);
    if (travelled > kWindowAhead) break;
  }
  known_ = true;
  revision_ = revision;
  place_ = best;
  return best;
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
