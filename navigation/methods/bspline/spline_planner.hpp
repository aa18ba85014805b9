#pragma once

#include "navigation/methods/bspline/spline_optimiser.hpp"
#include "navigation/methods/bspline/spline_seed.hpp"

namespace fulbito {

/// Shares, wishes and budgets of `bspline-time`.
struct BsplineTimeParams {
  double clearance = 0.055;         ///< [m] wish
  double least_clearance = 0.008;   ///< [m]
  double acceleration_share = 0.9;  ///< of the wheel acceleration
  double lateral_share = 0.75;      ///< of the lateral grip
  int evaluations = 16;             ///< a tick
  int effort = 480;                 ///< evaluations a plan, at most
  int moving_effort = 6;            ///< the same among moving discs
};

/// Plans the spline that `bspline-time` drives: tries the ways that the seeder offers, keeps the best and
/// goes on improving it.
class SplinePlanner {
 public:
  static constexpr double kAtRest = 0.15;  ///< [m/s] slower than that a start may turn in place

  explicit SplinePlanner(const BsplineTimeParams& params) : params_(params) {}
  /// Plans anew from the robot's place.
  /// @param discs         must stay valid and unchanged until the next plan
  /// @param any_moves     whether any of the discs does
  /// @param turn_at_goal  stop at the goal for a wanted heading rather than to drive through it
  void plan(const NavigationScene& scene, std::span<const ForecastDisc> discs, bool any_moves,
            bool turn_at_goal);
  /// Spends a tick's evaluations on the spline; true when it became better.
  /// @param first_free  control points before it stay: the robot is already driving there
  bool improve(bool any_moves, std::size_t first_free);

  const CubicSpline& spline() const { return best_.best(); }
  const SplineScore& score() const { return best_.score(); }
  /// What the spline was planned for.
  const SplineTask& task() const { return best_task_; }
  /// Whether the spline leaves a moving robot's direction so sharply that the turn is better made at rest.
  bool turnsSharply() const;

 private:
  /// Ways to arrive with a wanted heading.
  enum class Arrival { kFree, kThrough, kTurn };

  void setTask(const NavigationScene& scene, std::span<const ForecastDisc> discs);
  void choose(const NavigationScene& scene, Arrival arrival);
  void tryWays();
  void trySlower();
  void tryCandidate(const CubicSpline& seed);

  BsplineTimeParams params_;
  SplineSeeder seeder_;
  SplineCost cost_;
  SplineOptimiser best_;       ///< of the current plan
  SplineOptimiser candidate_;  ///< another way under trial
  SplineTask task_;
  SplineTask best_task_;
  SeedRequest request_;
  bool any_moves_ = false;
  bool wants_heading_ = false;
  int spent_ = 0;  ///< evaluations for this plan
};

}  // namespace fulbito
