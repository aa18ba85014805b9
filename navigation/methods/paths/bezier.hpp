#pragma once

#include "navigation/methods/paths/bezier_planner.hpp"
#include "navigation/methods/paths/path_navigator.hpp"

namespace fulbito {

/// Drives the guarded Bezier curve of `BezierPlanner`. If no curve keeps the clearance, it tries half of it,
/// then 5 mm, then the tangent graph's path. `counts()` tells how often.
class Bezier final : public PathNavigator {
 public:
  struct Params : PathNavigatorParams {
    double clearance = 0.02;   ///< [m] gap to the robot's circumscribed circle
    double alpha = 0.0;        ///< [m], see BezierPlannerParams
    bool all_sides = false;    ///< see BezierPlannerParams
    double hysteresis = 0.03;  ///< see BezierPlannerParams
  };
  /// Numbers of plans by outcome since the construction.
  struct Counts {
    std::uint64_t plans = 0;
    std::uint64_t tight = 0;    ///< plans with less clearance than wanted
    std::uint64_t tangent = 0;  ///< plans without a free curve: the tangent graph's path
    std::uint64_t blocked = 0;  ///< plans without any way
  };
  explicit Bezier(Params params);
  const Counts& counts() const { return counts_; }

 private:
  void forget() override;
  void makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                std::vector<Vec2>& path) override;
  double speedCap(const NavigationScene& scene) const override;
  bool findCurve(const NavigationScene& scene, std::span<const Circle> bodies);

  double clearance_;
  TangentPath tangent_path_;
  BezierPlanner planner_;
  bool on_tangent_path_ = false;
  Counts counts_;
};

}  // namespace fulbito
