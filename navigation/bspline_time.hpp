// Private header of navigation: not installed.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "navigation/drive_path.hpp"
#include "navigation/parameters.hpp"
#include "navigation/spline_optimiser.hpp"
#include "navigation/spline_seed.hpp"

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

/// Time-optimised cubic B-spline: the future work that Jung & Lee (2015) name, and the default method.
///
/// Seeds are the shortest way among the discs (tangent graph) and its neighbours on the other side of one
/// disc; a pattern search moves the control points so that the travel time under wheel and grip limits, with
/// a price on little clearance, becomes least. It begins to drive at once and goes on improving the part of
/// the spline that lies ahead. It plans anew when the goal moves, the robot is off the path, or discs,
/// foreseen straight on and mirrored at walls, come in the way; until a new plan is clear of them it drives
/// slower or stops.
class BsplineTime final : public Navigator {
 public:
  using Params = BsplineTimeParams;
  explicit BsplineTime(Params params = {});
  void reset() override;
  Guidance plan(const NavigationScene& scene) override;

 private:
  /// Ways to arrive with a wanted heading.
  enum class Arrival { kFree, kThrough, kTurn };

  bool goalMoved(const NavigationScene& scene) const;
  bool needsPlan(const NavigationScene& scene, double off_path) const;
  SeedRequest setTask(const NavigationScene& scene, double speed);
  void makePlan(const NavigationScene& scene);
  void choose(const NavigationScene& scene, const SeedRequest& request, Arrival arrival);
  void tryWays();
  void trySlower();
  void tryCandidate(const CubicSpline& seed);
  void brake(const NavigationScene& scene, double speed);
  void refine();
  double guard(const NavigationScene& scene);
  bool braces(const NavigationScene& scene) const;
  double slowDown(const NavigationScene& scene);
  bool discsChanged() const;
  double conflictAt(const NavigationScene& scene, double top, double horizon) const;

  Params params_;
  SplineSeeder seeder_;
  SplineCost cost_;
  SplineOptimiser best_;       ///< of the current plan
  SplineOptimiser candidate_;  ///< another way under trial
  SplineTask task_;
  SplineTask best_task_;
  DrivePath path_;
  std::vector<ForecastDisc> now_;      ///< discs as foreseen at this tick
  std::vector<ForecastDisc> planned_;  ///< as the plan foresaw them
  NavigationGoal goal_;
  bool any_moves_ = false;
  bool planned_once_ = false;
  bool braking_ = false;
  double cap_ = 0.0;             ///< [m/s] that the last look at moving discs allowed
  bool missed_heading_ = false;  ///< drove through the goal in the wrong heading: turn there
  int spent_ = 0;                ///< evaluations for this plan
  int age_ = 0;                  ///< ticks since the plan was made
  std::uint64_t revision_ = 0;
};

NavigatorInfo bsplineTimeInfo();

}  // namespace fulbito
