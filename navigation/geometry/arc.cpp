#include "fulbito/detail/arc.hpp"

#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

/// sin(a) / a, also at 0.
double sinc(double a) { return std::abs(a) < 1e-4 ? 1.0 - a * a / 6.0 : math::sin(a) / a; }

}  // namespace

Pose2 poseAt(const Arc& arc, double distance) {
  // The chord of a turn 2 h has the length 2 sin(h) / curvature and the direction of half the turn.
  const double half = arc.curvature * distance / 2;
  const double chord = distance * sinc(half), direction = arc.start.heading + half;
  return {arc.start.position + Vec2{math::cos(direction), math::sin(direction)} * chord,
          math::wrapAngle(arc.start.heading + 2 * half)};
}

Arc arcThrough(const Pose2& start, Vec2 point) {
  const Vec2 to = point - start.position;
  const Vec2 ahead{math::cos(start.heading), math::sin(start.heading)};
  const double x = dot(to, ahead), y = cross(ahead, to);
  const double squared = x * x + y * y;
  if (squared == 0.0) return {start, 0.0, 0.0};
  if (y == 0.0) return {start, 0.0, x > 0.0 ? x : std::numeric_limits<double>::infinity()};
  // The angle between tangent and chord is half the turn.
  const double turn = 2 * math::atan2(y, x);
  const double curvature = 2 * y / squared;
  return {start, curvature, turn / curvature};
}

}  // namespace fulbito
