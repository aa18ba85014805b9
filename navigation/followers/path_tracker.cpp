#include "navigation/followers/path_tracker.hpp"

namespace fulbito {
namespace {

constexpr double kWindowAhead = 0.25;  // [m] length of path searched ahead of the last place

}  // namespace

PathPlace PathTracker::locate(std::span<const Vec2> path, std::uint64_t revision, Vec2 p) {
  const bool fresh = !known_ || revision != revision_ || place_.segment + 1 >= path.size();
  const std::size_t begin = fresh ? 0 : place_.segment;
  PathPlace best{begin, 0.0};
  double best_distance = 1e300, travelled = 0.0;
  for (std::size_t i = begin; i + 1 < path.size(); ++i) {
    const double fraction = nearestShare(path[i], path[i + 1], p);
    const double d = squaredNorm(pointAt(path, {i, fraction}) - p);
    if (d < best_distance) best_distance = d, best = {i, fraction};
    if (!fresh && i > begin) travelled += distance(path[i], path[i + 1]);
    if (travelled > kWindowAhead) break;
  }
  known_ = true;
  revision_ = revision;
  place_ = best;
  return best;
}

}  // namespace fulbito
