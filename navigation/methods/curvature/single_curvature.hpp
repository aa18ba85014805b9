#pragma once

#include "navigation/methods/curvature/curve_navigator.hpp"

namespace fulbito {

/// Drives one arc from the robot's pose through the goal (Choi & Lee 2005, Fig. 8a). The robot turns to a
/// wanted heading at the goal.
class SingleCurvature final : public CurveNavigator {
 public:
  explicit SingleCurvature(Params params) : CurveNavigator(params) {}

 private:
  double makeCurve(const NavigationScene& scene, std::vector<Vec2>& path) override;
  void forget() override {}
};

}  // namespace fulbito
