#include "navigation/methods/curvature/double_arc.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {

namespace {

constexpr double kParallel = 1e-12;  // 1 minus the cosine; headings with a smaller value count as equal

/// The point where the arcs meet.
Vec2 joint(const Pose2& start, const Pose2& goal) {
  const Vec2 way = goal.position - start.position, middle = (start.position + goal.position) * 0.5;
  const Vec2 leave = math::unit(start.heading), arrive = math::unit(goal.heading);
  const double b = dot(way, leave + arrive), apart = 1.0 - dot(leave, arrive), square = squaredNorm(way);
  // also for a goal beside or behind, where the tangents are infinitely long
  if (apart < kParallel) return middle;
  // The ends of both tangents of length t are 2 t apart: (2 - 2 c) t^2 + 2 b t - way^2 = 0.
  const double tangent = square / (b + std::sqrt(b * b + 2.0 * apart * square));
  return middle + (leave - arrive) * (tangent / 2);
}

}  // namespace

DoubleArc doubleArc(const Pose2& start, const Pose2& goal) {
  if (start.position == goal.position) return {{start, 0.0, 0.0}, {start, 0.0, 0.0}};
  const Arc first = arcThrough(start, joint(start, goal));
  if (!std::isfinite(first.length)) return {first, {goal, 0.0, 0.0}};
  return {first, arcThrough(endOf(first), goal.position)};
}

}  // namespace fulbito
