#include "engine/core/models/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

using Corners = std::array<Vec2, 4>;

/// Signed distance of a point to a rectangle.
double pointClearance(const Rectangle& r, Vec2 p) {
  const Vec2 x = math::unit(r.pose.heading), d = p - r.pose.position;
  const double dx = std::abs(dot(x, d)) - r.length / 2, dy = std::abs(cross(x, d)) - r.width / 2;
  if (dx <= 0.0 && dy <= 0.0) return std::max(dx, dy);
  return norm({std::max(dx, 0.0), std::max(dy, 0.0)});
}

/// Largest gap between the two along the axes of `a`: negative on all axes of both means that they overlap.
double axisGap(const Rectangle& a, const Corners& b) {
  const Vec2 x = math::unit(a.pose.heading);
  double gap = -std::numeric_limits<double>::infinity();
  for (const auto& [axis, half] : {std::pair{x, a.length / 2}, std::pair{perp(x), a.width / 2}}) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Vec2 corner : b) {
      const double s = dot(axis, corner - a.pose.position);
      low = std::min(low, s);
      high = std::max(high, s);
    }
    gap = std::max({gap, low - half, -high - half});
  }
  return gap;
}

/// Distance of `p` to the closed contour: positive inside, negative outside.
double depthInside(std::span<const Vec2> contour, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Vec2 a = contour[i], b = contour[(i + 1) % contour.size()];
    const Vec2 edge = b - a;
    const double along = std::clamp(dot(p - a, edge) / squaredNorm(edge), 0.0, 1.0);
    least = std::min(least, distance(p, a + edge * along));
    // A ray along +x crosses the edge.
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside ? least : -least;
}

}  // namespace

std::array<Vec2, 4> cornersOf(const Rectangle& r) {
  const Vec2 x = math::unit(r.pose.heading);
  const Vec2 along = x * (r.length / 2), across = perp(x) * (r.width / 2);
  const Vec2 c = r.pose.position;
  return {c + along + across, c - along + across, c - along - across, c + along - across};
}

Rectangle bodyOf(const RobotModel& robot, const Pose2& pose) { return {pose, robot.length, robot.width}; }

double clearance(const Rectangle& body, Vec2 centre, double radius) {
  return pointClearance(body, centre) - radius;
}

double clearance(const Rectangle& a, const Rectangle& b) {
  const Corners corners_a = cornersOf(a), corners_b = cornersOf(b);
  const double gap = std::max(axisGap(a, corners_b), axisGap(b, corners_a));
  if (gap <= 0.0) return gap;
  // Apart: the nearest points of two convex polygons include a corner of one of them.
  double least = std::numeric_limits<double>::infinity();
  for (Vec2 corner : corners_b) least = std::min(least, pointClearance(a, corner));
  for (Vec2 corner : corners_a) least = std::min(least, pointClearance(b, corner));
  return least;
}

double clearance(const Rectangle& body, const ObstacleSpec& obstacle, const Pose2& pose) {
  if (obstacle.shape == ObstacleShape::kDisc) return clearance(body, pose.position, obstacle.radius);
  return clearance(body, Rectangle{pose, obstacle.length, obstacle.width});
}

double clearance(const Rectangle& body, std::span<const Vec2> contour) {
  double least = std::numeric_limits<double>::infinity();
  for (Vec2 corner : cornersOf(body)) least = std::min(least, depthInside(contour, corner));
  // A goal post can stand between two corners.
  for (Vec2 post : contour) least = std::min(least, pointClearance(body, post));
  return least;
}

}  // namespace fulbito
