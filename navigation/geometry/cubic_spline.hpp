#pragma once

#include <array>
#include <cstddef>

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// Weights of the four control points that shape one span of a uniform cubic B-spline, at one parameter.
struct SplineWeights {
  std::array<double, 4> position;
  std::array<double, 4> first;   ///< derivative by the span's parameter
  std::array<double, 4> second;  ///< second derivative
};

/// The weights at `u` in [0, 1] of a span (de Boor's uniform cubic basis; they sum to 1, 0 and 0).
constexpr SplineWeights splineWeights(double u) {
  const double w = 1.0 - u;
  return {{w * w * w / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
           (-3.0 * u * u * u + 3.0 * u * u + 3.0 * u + 1.0) / 6.0, u * u * u / 6.0},
          {-w * w / 2.0, (3.0 * u * u - 4.0 * u) / 2.0, (-3.0 * u * u + 2.0 * u + 1.0) / 2.0, u * u / 2.0},
          {w, 3.0 * u - 2.0, -3.0 * u + 1.0, u}};
}

/// The weights at `u` = 0, 1 / pieces ... 1.
template <std::size_t pieces>
constexpr std::array<SplineWeights, pieces + 1> splineWeightTable() {
  std::array<SplineWeights, pieces + 1> table{};
  for (std::size_t i = 0; i <= pieces; ++i) table[i] = splineWeights(static_cast<double>(i) / pieces);
  return table;
}

/// A place on a spline with its derivatives by the span's parameter.
struct SplinePoint {
  Vec2 position;
  Vec2 first;
  Vec2 second;
};

/// Uniform cubic B-spline with natural ends: it begins in the first control point, ends in the last, and is
/// straight in both. Moving a control point changes at most two spans on either side of it.
class CubicSpline {
 public:
  static constexpr std::size_t kMaxControls = 14;

  /// Empties the spline.
  void clear() { count_ = 0; }
  /// Adds a control point; ignored if there are already kMaxControls.
  void add(Vec2 control);
  void set(std::size_t i, Vec2 control);
  Vec2 control(std::size_t i) const { return points_[i + 1]; }
  std::size_t controls() const { return count_; }
  /// Number of spans between control points; 0 with fewer than two.
  std::size_t spans() const { return count_ < 2 ? 0 : count_ - 1; }
  /// The place in `span` (less than `spans()`) at the parameter of `weights`.
  SplinePoint at(std::size_t span, const SplineWeights& weights) const {
    SplinePoint point;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec2 c = points_[span + k];
      point.position += c * weights.position[k];
      point.first += c * weights.first[k];
      point.second += c * weights.second[k];
    }
    return point;
  }

 private:
  void closeEnds();

  std::array<Vec2, kMaxControls + 2> points_;  ///< with one phantom point beyond each end
  std::size_t count_ = 0;
};

/// Signed curvature [1/m]; 0 where the spline stands still.
double curvature(const SplinePoint& point);

}  // namespace fulbito
