#include "navigation/cubic_spline.hpp"

namespace fulbito {
namespace {

constexpr double kStill = 1e-9;  // [m] per parameter

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

SplinePoint CubicSpline::at(std::size_t span, const SplineWeights& weights) const {
  SplinePoint point;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 c = points_[span + k];
    point.position += c * weights.position[k];
    point.first += c * weights.first[k];
    point.second += c * weights.second[k];
  }
  return point;
}

double curvature(const SplinePoint& point) {
  const double speed = norm(point.first);
  return speed > kStill ? cross(point.first, point.second) / (speed * speed * speed) : 0.0;
}

}  // namespace fulbito
