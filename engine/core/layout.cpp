#include "engine/core/layout.hpp"

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

PathPosition alongPath(const ObstacleSpec& o, double time) {
  if (o.motion != ObstacleMotion::kPath || o.path.size() < 2) return {o.pose.position, {}};
  const double total = pathLength(o);
  if (!(total > 0.0)) return {o.path.front(), {}};
  double s = o.speed * time;
  double sense = 1.0;
  if (o.path_end == PathEnd::kStop) {
    if (s >= total) return {o.path.back(), {}};
  } else if (o.path_end == PathEnd::kCycle) {
    s -= std::floor(s / total) * total;
  } else {
    s -= std::floor(s / (2 * total)) * (2 * total);
    if (s > total) s = 2 * total - s, sense = -1.0;
  }
  const std::size_t count = o.path.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 a = o.path[i], b = o.path[(i + 1) % count];
    const double length = distance(a, b);
    const bool last = i + 1 == (o.path_end == PathEnd::kCycle ? count : count - 1);
    if (s <= length || last) {
      const Vec2 direction = unitOr(b - a, {});
      return {a + direction * std::min(s, length), direction * sense};
    }
    s -= length;
  }
  return {o.path.back(), {}};
}

}  // namespace

Vec2 positionAt(const ObstacleSpec& obstacle, double time) { return alongPath(obstacle, time).position; }

Vec2 velocityAt(const ObstacleSpec& obstacle, double time) {
  return alongPath(obstacle, time).direction * obstacle.speed;
}

}  // namespace fulbito
