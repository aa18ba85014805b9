#pragma once

#include <optional>

#include "navigation/methods/curvature/curve_navigator.hpp"

namespace fulbito {

/// Drives two arcs through a point of inflection (Choi & Lee 2005, Fig. 8b) to the goal's heading. If the
/// goal has none, the robot arrives with the heading that it had when it received the goal, as in the paper.
class DoubleCurvature final : public CurveNavigator {
 public:
  explicit DoubleCurvature(Params params) : CurveNavigator(params) {}

 private:
  double makeCurve(const NavigationScene& scene, std::vector<Vec2>& path) override;
  void forget() override { heading_.reset(); }
  double arrivalHeading(const NavigationScene& scene);

  std::optional<double> heading_;  // [rad] the robot's heading when it received the goal
  Vec2 goal_;
};

}  // namespace fulbito
