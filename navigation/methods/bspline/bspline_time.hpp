#pragma once

#include <vector>

#include "navigation/interface/parameters.hpp"
#include "navigation/methods/bspline/drive_path.hpp"
#include "navigation/methods/bspline/spline_planner.hpp"

namespace fulbito {

/// Time-optimised cubic B-spline: the future work that Jung & Lee (2015) mention, and the default method.
///
/// Its seeds are the shortest path among the discs (tangent graph) and variants that pass one disc on the
/// other side. A pattern search moves the control points to minimise the travel time under wheel and grip
/// limits, with a penalty for small clearance. The robot starts at once, while the search continues to
/// improve the part of the spline ahead. It plans anew if the goal moves, the robot is off the path, or discs
/// block the path. Discs are predicted along straight lines, mirrored at walls. Until a new plan is clear of
/// them, the robot slows down or stops.
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
  std::vector<ForecastDisc> now_;      ///< predicted discs at this tick
  std::vector<ForecastDisc> planned_;  ///< predicted discs at the time of the plan
  NavigationGoal goal_;
  bool any_moves_ = false;
  bool planned_once_ = false;
  bool braking_ = false;
  double cap_ = 0.0;             ///< [m/s] speed cap of the last check of moving discs
  bool missed_heading_ = false;  ///< the robot passed the goal in a wrong heading: turn there
  int age_ = 0;                  ///< ticks since the plan was made
  std::uint64_t revision_ = 0;
};

}  // namespace fulbito
