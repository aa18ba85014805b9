#include "navigation/methods/bspline/drive_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulbito {
namespace {

constexpr std::size_t kPerSpan = 8;
constexpr std::size_t kReserve = (CubicSpline::kMaxControls - 1) * kPerSpan + 2;
constexpr std::size_t kWindow = 24;       // number of points searched ahead of the last place
constexpr double kRideStep = 1.0 / 30.0;  // [s] time step of a slow ride
constexpr double kRideWay = 0.04;         // [m] greatest step of a fast ride
constexpr std::size_t kAhead = 2;         // number of points ahead of the robot's place
constexpr double kOwnMotion = 0.02;       // [m/s] if the robot is slower, the disc drives into the robot

constexpr auto kWeights = splineWeightTable<kPerSpan>();

}  // namespace

DrivePath::DrivePath() {
  points_.reserve(kReserve);
  along_.reserve(kReserve);
  curvature_.reserve(kReserve);
  speeds_.reserve(kReserve);
  spacing_.reserve(kReserve);
}

void DrivePath::clear() {
  points_.clear();
  along_.clear();
  curvature_.clear();
  speeds_.clear();
  spacing_.clear();
  place_ = 0;
}

void DrivePath::build(const CubicSpline& spline, SpeedLimits limits) {
  const std::size_t place = place_;
  clear();
  const auto put = [this](const SplinePoint& point) {
    spacing_.push_back(points_.empty() ? 0.0 : spacing_.back() + distance(points_.back(), point.position));
    points_.push_back(point.position);
    along_.push_back(unitOr(point.first, along_.empty() ? Vec2{1.0, 0.0} : along_.back()));
    curvature_.push_back(curvature(point));
  };
  for (std::size_t s = 0; s < spline.spans(); ++s) {
    for (std::size_t i = 0; i < kPerSpan; ++i) put(spline.at(s, kWeights[i]));
  }
  if (spline.spans() > 0) put(spline.at(spline.spans() - 1, kWeights.back()));
  speeds_.resize(points_.size());
  limits.start_speed = 1e9;
  timePath(points_, curvature_, limits, speeds_);
  place_ = points_.empty() ? 0 : std::min(place, points_.size() - 1);
}

void DrivePath::brake(Vec2 position, Vec2 direction, double length) {
  clear();
  for (const double way : {0.0, std::max(length, 0.05)}) {
    points_.push_back(position + direction * way);
    along_.push_back(direction);
    curvature_.push_back(0.0);
    speeds_.push_back(0.0);
    spacing_.push_back(way);
  }
}

double DrivePath::advanceTo(Vec2 position) {
  if (points_.empty()) return 0.0;
  double least = squaredNorm(points_[place_] - position);
  const std::size_t end = std::min(place_ + kWindow, points_.size());
  for (std::size_t i = place_ + 1; i < end; ++i) {
    const double d = squaredNorm(points_[i] - position);
    if (d < least) least = d, place_ = i;
  }
  return std::sqrt(least);
}

Vec2 DrivePath::directionAhead() const {
  return along_.empty() ? Vec2{} : along_[std::min(place_ + kAhead, along_.size() - 1)];
}

std::size_t DrivePath::span() const { return place_ / kPerSpan; }

double DrivePath::conflict(const Ride& ride, const BodyShape& body,
                           std::span<const ForecastDisc> discs) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double reach = ride.margin + body.circumradius();
  double speed = ride.speed, way = points_.empty() ? 0.0 : spacing_[place_];
  std::size_t i = place_;
  double time = 0.0;
  while (time < ride.horizon && i + 1 < points_.size()) {
    const double step = std::min(kRideStep, kRideWay / std::max(speed, kOwnMotion));
    time += step;
    const double wanted = std::min(ride.top, speeds_[i]), change = ride.acceleration * step;
    speed += std::clamp(wanted - speed, -change, time > ride.hold ? change : 0.0);
    if (speed < kOwnMotion) return kNone;
    way += speed * step;
    while (i + 1 < points_.size() && spacing_[i + 1] < way) ++i;
    const std::size_t next = std::min(i + 1, points_.size() - 1);
    const double gap = spacing_[next] - spacing_[i];
    const double part = gap > 0.0 ? std::min(1.0, (way - spacing_[i]) / gap) : 0.0;
    const Vec2 position = points_[i] + (points_[next] - points_[i]) * part;
    for (const ForecastDisc& disc : discs) {
      if (way > ride.end && !disc.moves) continue;
      const Vec2 centre = disc.at(time);
      const double margin = ride.margin + (disc.moves ? ride.margin_growth * time : 0.0);
      const double near = reach + margin + disc.radius;
      if (squaredNorm(centre - position) > near * near) continue;
      // Driving away from a disc that already touches the robot is not a conflict.
      if (dot(along_[i], centre - position) <= 0.0) continue;
      if (discClearance(body, position, along_[i], centre, disc.radius) < margin) return time;
    }
  }
  return kNone;
}

}  // namespace fulbito
