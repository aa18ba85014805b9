#pragma once

#include "navigation/parameters.hpp"
#include "navigation/replan_monitor.hpp"
#include "navigation/tangent_path.hpp"

namespace fulbito {

/// Follows the exact shortest path among the discs (`TangentPath`): the distance limit that the comparison's
/// L* stands for. Plans when the scene changes or the robot strays, not at every tick. Moving obstacles are
/// planned with where they will be met.
class TangentGraphNavigator final : public Navigator {
 public:
  struct Params {
    double margin = 0.005;     ///< [m], see TangentPathParams
    double hysteresis = 0.03;  ///< see TangentPathParams
    double approach = 0.08;    ///< [m], see TangentPathParams
    double bend = 0.06;        ///< [m], see TangentPathParams
    double horizon = 0.5;      ///< [s] farthest look ahead at moving obstacles
    double yield = 1.0;        ///< [s] look ahead of yieldSpeed
    Replan replan = Replan::kChange;
  };
  explicit TangentGraphNavigator(Params params);
  void reset() override;
  Guidance plan(const NavigationScene& scene) override;

 private:
  Params params_;
  TangentPath tangent_path_;
  ReplanMonitor monitor_;
  std::vector<Circle> bodies_;
  std::vector<Vec2> path_;
  std::uint64_t revision_ = 0;
  bool blocked_ = false;
};

NavigatorInfo tangentGraphInfo();

}  // namespace fulbito
