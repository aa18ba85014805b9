#include "experiments/papers/transport/part_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fulbito/models.hpp"

namespace fulbito {
namespace {

double nearestOnCircle(const Arc& arc, Vec2 point) {
  const double radius = 1.0 / arc.curvature;  // signed: positive for a left turn, whose centre is on the left
  const Vec2 centre = arc.start.position + perp(math::unit(arc.start.heading)) * radius;
  const Vec2 first = arc.start.position - centre, to = point - centre;
  double turn = math::atan2(cross(first, to), dot(first, to));
  if (arc.curvature < 0.0) turn = -turn;
  if (turn < 0.0) turn += 2 * math::kPi;
  const double along = turn * std::abs(radius);
  if (along <= arc.length) return along;
  return distance(point, endOf(arc).position) < distance(point, arc.start.position) ? arc.length : 0.0;
}

}  // namespace

double nearestOn(const Arc& arc, Vec2 point) {
  if (arc.curvature != 0.0) return nearestOnCircle(arc, point);
  return std::clamp(dot(point - arc.start.position, math::unit(arc.start.heading)), 0.0, arc.length);
}

PartPath::PartPath(std::vector<Arc> parts) : parts_(std::move(parts)) {
  for (const Arc& part : parts_) from_.push_back(from_.back() + part.length);
}

std::size_t PartPath::partAt(double q) const {
  const auto after = std::upper_bound(from_.begin(), from_.end(), q);
  const auto index = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - from_.begin() - 1, 0));
  return std::min(index, parts_.size() - 1);
}

double PartPath::jumpAfter(std::size_t part) const {
  return math::wrapAngle(parts_[part + 1].start.heading - endOf(parts_[part]).heading);
}

double PartPath::nearest(Vec2 point) const {
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const double along = nearestOn(parts_[i], point);
    const double gap = distance(poseAt(parts_[i], along).position, point);
    if (gap < least) least = gap, best = from_[i] + along;
  }
  return best;
}

std::vector<Vec2> pointsAlong(const PartPath& path, double stride, Vec2 origin) {
  const auto count = static_cast<std::size_t>(std::ceil(path.length() / stride));
  std::vector<Vec2> points;
  points.reserve(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    const double along = path.length() * static_cast<double>(i) / static_cast<double>(count);
    points.push_back(path.pose(along).position - origin);
  }
  return points;
}

}  // namespace fulbito
