// Vectors in the plane: plain arithmetic on two doubles.
#pragma once

#include <cmath>

namespace fulbito {

/// Plane vector or point, [m] unless stated otherwise.
struct Vec2 {
  double x = 0.0;  ///< along the field, toward the right goal
  double y = 0.0;  ///< across the field, counter-clockwise of x

  /// Adds each component.
  constexpr Vec2& operator+=(Vec2 o) {
    x += o.x, y += o.y;
    return *this;
  }
  /// Subtracts each component.
  constexpr Vec2& operator-=(Vec2 o) {
    x -= o.x, y -= o.y;
    return *this;
  }
  /// Multiplies both components.
  constexpr Vec2& operator*=(double s) {
    x *= s, y *= s;
    return *this;
  }
  /// Exact comparison of both components; -0 equals +0.
  friend constexpr bool operator==(Vec2, Vec2) = default;
};

/// Sum of each component.
constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
/// Difference of each component.
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
/// The opposite vector.
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
/// Both components times `s`.
constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
/// Both components times `s`.
constexpr Vec2 operator*(double s, Vec2 a) { return {a.x * s, a.y * s}; }
/// Both components divided by `s`.
constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }

/// Scalar product.
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// z component of the cross product: positive when `b` lies counter-clockwise of `a`.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// `a` turned by +90 degrees.
constexpr Vec2 perp(Vec2 a) { return {-a.y, a.x}; }
/// Square of the length: cheaper than `norm` for comparisons.
constexpr double squaredNorm(Vec2 a) { return dot(a, a); }
/// Length.
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }
/// Distance between `a` and `b`.
inline double distance(Vec2 a, Vec2 b) { return norm(a - b); }
/// @{ Components of `v` in the frame whose x axis is the unit vector `x_axis`, and back.
constexpr Vec2 intoFrame(Vec2 x_axis, Vec2 v) { return {dot(x_axis, v), cross(x_axis, v)}; }
/// Inverse of `intoFrame`.
constexpr Vec2 outOfFrame(Vec2 x_axis, Vec2 v) { return x_axis * v.x + perp(x_axis) * v.y; }
/// @}
/// Unit vector of `a`, or `fallback` if `a` is zero or not finite.
inline Vec2 unitOr(Vec2 a, Vec2 fallback) {
  const double length = norm(a);
  return length > 0.0 && length < 1e300 ? a / length : fallback;
}
/// Whether neither component is infinite or NaN.
inline bool isFinite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace fulbito
