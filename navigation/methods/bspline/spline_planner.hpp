#pragma once

#include "navigation/methods/bspline/spline_optimiser.hpp"
#include "navigation/methods/bspline/spline_seed.hpp"

namespace fulbito {

/// Parameters of `bspline-time`.
struct BsplineTimeParams {
  double clearance = 0.055;         ///< [m] wanted clearance
  double least_clearance = 0.008;   ///< [m] least clearance
  double acceleration_share = 0.9;  ///< share of the wheel acceleration
  double lateral_share = 0.75;      ///< share of the lateral grip
  int evaluations = 16;             ///< evaluations per tick
  int effort = 480;                 ///< greatest number of evaluations per plan
  int moving_effort = 6;            ///< the same among moving discs
};

/// Plans the spline that `bspline-time` drives. It tries the ways that the seeder offers, keeps the best and
/// continues to improve it.
class SplinePlanner {
 public:
  static constexpr double kAtRest = 0.15;  ///< [m/s] a slower robot may turn in place at the start

  explicit SplinePlanner(const BsplineTimeParams& params) : params_(params) {}
  /// Plans anew from the robot's place.
  /// @param discs         must stay valid and unchanged until the next plan
  /// @param any_moves     whether any of the discs moves
  /// @param turn_at_goal  stop at the goal and turn to its heading instead of driving through it
  void plan(const NavigationScene& scene, std::span<const ForecastDisc> discs, bool any_moves,
            bool turn_at_goal);
  /// Spends one tick's evaluations on the spline. Returns whether it has improved.
  /// @param first_free  control points before it stay, since the robot already drives there
  bool improve(bool any_moves, std::size_t first_free);

  const CubicSpline& spline() const { return best_.best(); }
  const SplineScore& score() const { return best_.score(); }
  /// The task of the current plan.
  const SplineTask& task() const { return best_task_; }
  /// Whether the spline leaves a moving robot's direction so sharply that the robot should turn at rest.
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
  SplineOptimiser best_;       ///< optimiser of the current plan
  SplineOptimiser candidate_;  ///< optimiser of another way on trial
  SplineTask task_;
  SplineTask best_task_;
  SeedRequest request_;
  bool any_moves_ = false;
  bool wants_heading_ = false;
  int spent_ = 0;  ///< evaluations used by this plan
};

}  // namespace fulbito
