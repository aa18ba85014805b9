#pragma once

#include <array>
#include <cstddef>

#include "navigation/methods/bspline/spline_cost.hpp"

namespace fulbito {

/// Improves a spline by deterministic pattern search (Hooke & Jeeves 1961, one direction per move). Control
/// points move across the seed path, one at a time and as bumps of five and nine. Every direction has its own
/// step: it grows after an improvement, changes its sign after a failure, and shrinks after failures both
/// ways. The work can be spread over many calls, and the result never gets worse.
class SplineOptimiser {
 public:
  /// Starts from `seed`. Its first `fixed_front` and last `fixed_back` control points never move.
  /// @param step  [m] initial step
  void start(const CubicSpline& seed, std::size_t fixed_front, std::size_t fixed_back, double step);
  /// Fixes the control points before `index` from now on, since the robot already drives there.
  void freezeBefore(std::size_t index);
  /// Tries up to `evaluations` changes and returns their number: fewer only if the search has converged.
  int improve(SplineCost& cost, int evaluations);

  bool converged() const;
  const CubicSpline& best() const { return best_; }
  const SplineScore& score() const { return score_; }

 private:
  static constexpr std::size_t kWidths = 3;
  static constexpr std::size_t kDirections = kWidths * CubicSpline::kMaxControls;
  struct Direction {
    double step = 0.0;      ///< [m] signed: the way of the last improvement comes first
    bool reversed = false;  ///< the other way has been tried
  };

  CubicSpline moved(std::size_t direction, double by) const;
  bool live(std::size_t direction) const;
  void learn(Direction& direction, bool better);
  void next();

  CubicSpline best_;
  SplineScore score_;
  std::array<Vec2, CubicSpline::kMaxControls> across_;  ///< unit vectors across the seed path
  std::array<Direction, kDirections> directions_;
  std::size_t first_ = 0, end_ = 0;  ///< range of control points that may move
  std::size_t turn_ = 0;             ///< direction of the next trial
  bool scored_ = false;
};

}  // namespace fulbito
