#pragma once

#include "navigation/bezier_planner.hpp"
#include "navigation/parameters.hpp"
#include "navigation/replan_monitor.hpp"

namespace fulbito {

/// Drives the guarded Bezier curve (`BezierPlanner`). Plans when the scene changes or the robot strays.
/// Where no curve keeps the clearance, half of it and then 5 mm are tried, then the tangent graph's path is
/// driven; `counts()` tells how often.
class Bezier final : public Navigator {
 public:
  struct Params {
    double clearance = 0.02;  ///< [m] beside the robot's circumscribed circle
    double alpha = 0.0;       ///< [m], see BezierPlannerParams
    bool all_sides = false;   ///< see BezierPlannerParams
    double hysteresis = 0.03;
    double horizon = 0.5;  ///< [s] farthest look ahead at moving obstacles
    double yield = 1.0;    ///< [s] look ahead of yieldSpeed
    Replan replan = Replan::kChange;
  };
  /// How the plans since the construction came out.
  struct Counts {
    std::uint64_t plans = 0;
    std::uint64_t tight = 0;    ///< with less clearance than wanted
    std::uint64_t tangent = 0;  ///< no curve: the tangent graph's path
    std::uint64_t blocked = 0;  ///< no way at all
  };
  explicit Bezier(Params params);
  void reset() override;
  Guidance plan(const NavigationScene& scene) override;
  const Counts& counts() const { return counts_; }

 private:
  void replan(const NavigationScene& scene);
  bool findCurve(const NavigationScene& scene);

  Params params_;
  TangentPath tangent_path_;
  BezierPlanner planner_;
  ReplanMonitor monitor_;
  std::vector<Circle> bodies_;
  std::vector<Vec2> path_;
  std::uint64_t revision_ = 0;
  bool blocked_ = false;
  bool on_tangent_path_ = false;
  Counts counts_;
};

NavigatorInfo bezierInfo();

}  // namespace fulbito
