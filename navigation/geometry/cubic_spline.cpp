#include "navigation/geometry/cubic_spline.hpp"

namespace fulbito {
namespace {

constexpr double kStill = 1e-9;  // [m] per unit of the parameter

}  // namespace

void CubicSpline::add(Vec2 control) {
  if (count_ == kMaxControls) return;
  points_[++count_] = control;
  closeEnds();
}

void CubicSpline::set(std::size_t i, Vec2 control) {
  points_[i + 1] = control;
  if (i < 2 || i + 2 >= count_) closeEnds();
}

void CubicSpline::closeEnds() {
  if (count_ < 2) return;
  points_[0] = 2.0 * points_[1] - points_[2];
  points_[count_ + 1] = 2.0 * points_[count_] - points_[count_ - 1];
}

double curvature(const SplinePoint& point) {
  const double speed = norm(point.first);
  return speed > kStill ? cross(point.first, point.second) / (speed * speed * speed) : 0.0;
}

}  // namespace fulbito
