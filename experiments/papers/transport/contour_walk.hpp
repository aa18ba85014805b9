#pragma once

#include "experiments/papers/transport/constraint_curve.hpp"

namespace fulbito {

/// Where a walk along a contour leaves the square of both coordinates.
struct ContourEnd {
  CurveEnd end = CurveEnd::kLoop;  ///< never kBranch
  double lead = 0.0;               ///< [m]
  double follower = 0.0;           ///< [m]
};

/// Follows the same set as `traceCurve` by other means: it walks through the cells of a grid, whose corners
/// say on which side of the rod's length they are. It needs neither tangents nor speeds, so it can tell
/// whether a refusal is right. Two ways that come closer than a cell may be mixed up.
///
/// @param cell  [m] size of the grid's cells
ContourEnd walkContour(const TransportTask& task, double cell);

}  // namespace fulbito
