#pragma once

#include <vector>

#include "navigation/interface/parameters.hpp"
#include "navigation/methods/bspline/drive_path.hpp"
#include "navigation/methods/bspline/spline_planner.hpp"

namespace fulbito {

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
  bool goalMoved(const NavigationScene& scene) const;
  bool needsPlan(const NavigationScene& scene, double off_path) const;
  void makePlan(const NavigationScene& scene);
  void brake(const NavigationScene& scene, double speed);
  void refine();
  double guard(const NavigationScene& scene);
  bool collisionUnavoidable(const NavigationScene& scene) const;
  double slowDown(const NavigationScene& scene);
  bool discsChanged() const;
  double conflictAt(const NavigationScene& scene, double top, double horizon) const;

  Params params_;
  SplinePlanner planner_;
  DrivePath path_;
  std::vector<ForecastDisc> now_;      ///< discs as foreseen at this tick
  std::vector<ForecastDisc> planned_;  ///< as the plan foresaw them
  NavigationGoal goal_;
  bool any_moves_ = false;
  bool planned_once_ = false;
  bool braking_ = false;
  double cap_ = 0.0;             ///< [m/s] that the last look at moving discs allowed
  bool missed_heading_ = false;  ///< drove through the goal in the wrong heading: turn there
  int age_ = 0;                  ///< ticks since the plan was made
  std::uint64_t revision_ = 0;
};

}  // namespace fulbito
