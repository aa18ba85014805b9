#pragma once

#include <span>

#include "fulbito/models.hpp"

namespace fulbito::capture {

/// A circle fitted to points.
struct FittedCircle {
  Vec2 centre;          ///< [m]
  double radius = 0.0;  ///< [m]
};

/// The circle through points by least squares over |p|^2 = 2 c p + (r^2 - c^2), which is exact for points on
/// a circle (Kasa 1976). Needs three points that are not on a line.
FittedCircle fitCircle(std::span<const Vec2> points);

}  // namespace fulbito::capture
