#include "tests/second_referee/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fulbito::second {
namespace {

/// Where the body lies at one distance from the goal line.
struct Slice {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return low > high; }
  /// [m] from the area's axis to the nearest point of the slice.
  double fromAxis() const { return std::max({low, -high, 0.0}); }
};

Slice sliceAt(const Corners& uv, double u) {
  Slice slice;
  const auto add = [&](double v) {
    slice.low = std::min(slice.low, v);
    slice.high = std::max(slice.high, v);
  };
  for (std::size_t i = 0; i < uv.size(); ++i) {
    const Vec2 a = uv[i], b = uv[(i + 1) % uv.size()];
    if (a.x == u) add(a.y);
    if ((a.x < u && b.x > u) || (a.x > u && b.x < u)) add(a.y + (b.y - a.y) * (u - a.x) / (b.x - a.x));
  }
  return slice;
}

double leastU(const Corners& uv) { return std::min({uv[0].x, uv[1].x, uv[2].x, uv[3].x}); }
double mostU(const Corners& uv) { return std::max({uv[0].x, uv[1].x, uv[2].x, uv[3].x}); }

/// Least value of a convex function between two places.
template <typename F>
double leastOf(F f, double from, double to) {
  const double golden = (std::sqrt(5.0) - 1.0) / 2.0;
  double least = std::min(f(from), f(to));
  for (int i = 0; i < 80; ++i) {
    const double width = (to - from) * golden, left = to - width, right = from + width;
    const double at_left = f(left), at_right = f(right);
    least = std::min({least, at_left, at_right});
    (at_left < at_right ? to : from) = at_left < at_right ? right : left;
  }
  return least;
}

/// Simpson's rule, halved until both halves agree with the whole.
template <typename F>
double integral(F f, double a, double b, double fa, double fm, double fb, double tolerance, int depth) {
  const double m = (a + b) / 2, left = f((a + m) / 2), right = f((m + b) / 2);
  const double whole = (b - a) / 6 * (fa + 4 * fm + fb);
  const double halves = (b - a) / 12 * (fa + 4 * left + 2 * fm + 4 * right + fb);
  if (depth <= 0 || (depth < 34 && std::abs(halves - whole) <= 15 * tolerance)) return halves;
  return integral(f, a, m, fa, left, fm, tolerance / 2, depth - 1) +
         integral(f, m, b, fm, right, fb, tolerance / 2, depth - 1);
}

/// [m] of the slice at `u` that is in the area.
double widthIn(const Marking& area, const Corners& uv, double u) {
  const Slice slice = sliceAt(uv, u);
  if (slice.empty()) return 0.0;
  const double half = area.halfWidthAt(u);
  return std::max(0.0, std::min(slice.high, half) - std::max(slice.low, -half));
}

}  // namespace

double Marking::halfWidthAt(double u) const {
  if (u <= depth) return half_width;
  const double along = u - arc_u;
  return std::sqrt(std::max(0.0, arc_radius * arc_radius - along * along));
}

Marking Marking::widened(double margin) const {
  Marking wide = *this;
  if (half_width > 0.0) wide.half_width += margin, wide.depth += margin;
  if (arc_radius > 0.0) wide.arc_radius += margin;
  return wide;
}

Marking goalArea(const FieldGeometry& field, bool with_arc) {
  Marking area{field.goal_area_width / 2, field.goal_area_depth, 0.0, 0.0};
  if (!with_arc || field.goal_area_arc_width <= 0.0 || field.goal_area_arc_depth <= 0.0) return area;
  // A chord of this width with the arc this far beyond it: r^2 = (w/2)^2 + (r - h)^2.
  const double w = field.goal_area_arc_width, h = field.goal_area_arc_depth;
  area.arc_radius = h / 2 + w * w / (8 * h);
  area.arc_u = field.goal_area_depth + h - area.arc_radius;
  return area;
}

Marking bigArea(const FieldGeometry& field) { return {field.big_area_width / 2, field.big_area_depth, 0, 0}; }

Vec2 atEnd(const FieldGeometry& field, int end, Vec2 point) {
  return {field.length / 2 - end * point.x, point.y};
}

Corners cornersOf(const Pose2& pose, double length, double width) {
  const double c = std::cos(pose.heading), s = std::sin(pose.heading);
  const auto corner = [&](double x, double y) {
    return Vec2{pose.position.x + c * x - s * y, pose.position.y + s * x + c * y};
  };
  const double l = length / 2, w = width / 2;
  return {corner(l, w), corner(-l, w), corner(-l, -w), corner(l, -w)};
}

bool isIn(const Marking& area, Vec2 uv) {
  if (area.half_width <= 0.0) return false;
  return std::abs(uv.y) <= area.halfWidthAt(uv.x) && (uv.x <= area.depth || area.arc_radius > 0.0) &&
         (uv.x <= area.depth || uv.x <= area.arc_u + area.arc_radius);
}

bool anyPartIn(const Marking& area, const Corners& uv) {
  if (area.half_width <= 0.0) return false;
  const double least = leastU(uv), most = mostU(uv);
  const auto from_axis = [&](double u) { return sliceAt(uv, u).fromAxis(); };
  if (least < area.depth && leastOf(from_axis, least, std::min(most, area.depth)) < area.half_width)
    return true;
  if (area.arc_radius <= 0.0 || most <= area.depth) return false;
  const auto from_centre = [&](double u) { return std::hypot(u - area.arc_u, from_axis(u)); };
  return leastOf(from_centre, std::max(least, area.depth), most) < area.arc_radius;
}

double shareIn(const Marking& area, const Corners& uv) {
  if (area.half_width <= 0.0) return 0.0;
  std::vector<double> edges = {area.depth, area.arc_u + area.arc_radius};
  for (const Vec2 corner : uv) edges.push_back(corner.x);
  std::sort(edges.begin(), edges.end());
  const auto inside = [&](double u) { return widthIn(area, uv, u); };
  double covered = 0.0;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    // Just off the edges: at them the width may jump.
    const double a = std::nextafter(edges[i - 1], edges[i]), b = std::nextafter(edges[i], edges[i - 1]);
    if (b <= a) continue;
    covered += integral(inside, a, b, inside(a), inside((a + b) / 2), inside(b), 1e-13, 36);
  }
  const Vec2 l = uv[1] - uv[0], w = uv[2] - uv[1];
  return covered / (std::hypot(l.x, l.y) * std::hypot(w.x, w.y));
}

double gapBetween(const Pose2& pose, double length, double width, Vec2 ball, double radius) {
  const double c = std::cos(pose.heading), s = std::sin(pose.heading);
  const Vec2 off = ball - pose.position;
  const double along = std::abs(c * off.x + s * off.y) - length / 2;
  const double across = std::abs(c * off.y - s * off.x) - width / 2;
  if (along <= 0.0 && across <= 0.0) return std::max(along, across) - radius;
  return std::hypot(std::max(along, 0.0), std::max(across, 0.0)) - radius;
}

}  // namespace fulbito::second
