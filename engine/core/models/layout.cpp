#include "fulbito/detail/layout.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

double pathLength(const ObstacleSpec& o) {
  double length = 0.0;
  for (std::size_t i = 1; i < o.path.size(); ++i) length += distance(o.path[i - 1], o.path[i]);
  if (o.path_end == PathEnd::kCycle && o.path.size() > 1) length += distance(o.path.back(), o.path.front());
  return length;
}

struct PathPosition {
  Vec2 position;
  Vec2 direction;  // unit, in the sense of motion; zero at rest
};

// Position and direction on the path after `travelled` metres, by unrolling one period.
struct Progress {
  double along = 0.0;  // from the first waypoint, within [0, total]
  double sense = 1.0;  // 0 at rest
};

Progress progressAlong(PathEnd end, double total, double travelled) {
  if (!std::isfinite(travelled)) travelled = 0.0;
  if (end == PathEnd::kStop) {
    return travelled >= total ? Progress{total, 0.0} : Progress{std::max(travelled, 0.0), 1.0};
  }
  const double period = end == PathEnd::kCycle ? total : 2 * total;
  const double phase = std::clamp(travelled - std::floor(travelled / period) * period, 0.0, period);
  return phase < total || end == PathEnd::kCycle ? Progress{phase, 1.0} : Progress{period - phase, -1.0};
}

PathPosition alongPath(const ObstacleSpec& o, double time) {
  if (o.motion != ObstacleMotion::kPath || o.path.size() < 2) return {o.pose.position, {}};
  const double total = pathLength(o);
  if (!(total > 0.0)) return {o.path.front(), {}};
  const auto [along, sense] = progressAlong(o.path_end, total, o.speed * time);
  const std::size_t count = o.path.size();
  const std::size_t stretches = o.path_end == PathEnd::kCycle ? count : count - 1;
  double left = along;
  PathPosition result{o.path.front(), {}};
  for (std::size_t i = 0; i < stretches; ++i) {
    const Vec2 a = o.path[i], b = o.path[(i + 1) % count];
    const double length = distance(a, b);
    if (!(length > 0.0)) continue;
    const Vec2 direction = (b - a) / length;
    result = {a + direction * std::min(left, length), direction * sense};
    // A waypoint belongs to the next segment.
    if (sense < 0.0 ? left <= length : left < length) break;
    left -= length;
  }
  return result;
}

}  // namespace

Vec2 positionAt(const ObstacleSpec& obstacle, double time) { return alongPath(obstacle, time).position; }

Vec2 velocityAt(const ObstacleSpec& obstacle, double time) {
  return alongPath(obstacle, time).direction * obstacle.speed;
}

}  // namespace fulbito
