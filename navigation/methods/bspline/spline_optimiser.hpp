#pragma once

#include <array>
#include <cstddef>

#include "navigation/methods/bspline/spline_cost.hpp"

namespace fulbito {

/// Improves a spline by deterministic pattern search (Hooke & Jeeves 1961, one direction a move): control
/// points move across the seed path, one by one and as bumps five and nine wide. Every direction has a step
/// of its own that grows where it helps, is turned about where it does not, and shrinks where neither way
/// helps. The work can be spread over many calls; the result never gets worse.
class SplineOptimiser {
 public:
  /// Begins anew from `seed`; its first and last `fixed_*` control points never move.
  /// @param step  [m] first step
  void start(const CubicSpline& seed, std::size_t fixed_front, std::size_t fixed_back, double step);
  /// From now on control points before `index` stay where they are: the robot is already driving there.
  void freezeBefore(std::size_t index);
  /// Tries up to `evaluations` changes and returns how many were tried: less only when it has converged.
  int improve(SplineCost& cost, int evaluations);

  bool converged() const;
  const CubicSpline& best() const { return best_; }
  const SplineScore& score() const { return score_; }

 private:
  static constexpr std::size_t kWidths = 3;
  static constexpr std::size_t kDirections = kWidths * CubicSpline::kMaxControls;
  struct Direction {
    double step = 0.0;      ///< [m], signed: the way that helped last comes first
    bool reversed = false;  ///< the other way was tried already
  };

  CubicSpline moved(std::size_t direction, double by) const;
  bool live(std::size_t direction) const;
  void learn(Direction& direction, bool better);
  void next();

  CubicSpline best_;
  SplineScore score_;
  std::array<Vec2, CubicSpline::kMaxControls> across_;  ///< unit vectors
  std::array<Direction, kDirections> directions_;
  std::size_t first_ = 0, end_ = 0;  ///< control points that may move
  std::size_t turn_ = 0;             ///< direction that is tried next
  bool scored_ = false;
};

}  // namespace fulbito
