#pragma once

#include "experiments/papers/transport/constraint_curve.hpp"

namespace fulbito {

/// Where a walk along a contour leaves the square of both coordinates.
struct ContourEnd {
  CurveEnd end = CurveEnd::kLoop;  ///< never kBranch
  double lead = 0.0;               ///< [m]
  double follower = 0.0;           ///< [m]
};

/// Follows the same set as `traceCurve` by another method: it walks through the cells of a grid. At each
/// corner of a cell, the distance of the robots is above or below the rod's length. It needs neither tangents
/// nor speeds, so it can check a refusal independently. It may confuse two branches that are closer than a
/// cell.
///
/// @param cell  [m] size of the grid's cells
ContourEnd walkContour(const TransportTask& task, double cell);

}  // namespace fulbito
