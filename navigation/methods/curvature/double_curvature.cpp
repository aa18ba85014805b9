#include "navigation/methods/curvature/double_curvature.hpp"

#include <cmath>

#include "navigation/methods/curvature/double_arc.hpp"

namespace fulbito {

double DoubleCurvature::arrivalHeading(const NavigationScene& scene) {
  if (scene.goal.heading) return *scene.goal.heading;
  if (!heading_ || distance(goal_, scene.goal.position) > scene.goal.tolerance) {
    heading_ = scene.self.pose.heading;
    goal_ = scene.goal.position;
  }
  return *heading_;
}

double DoubleCurvature::makeCurve(const NavigationScene& scene, std::vector<Vec2>& path) {
  const DoubleArc arcs = doubleArc(scene.self.pose, {scene.goal.position, arrivalHeading(scene)});
  if (!std::isfinite(arcs.length())) return arcs.length();
  appendArc(arcs.first, path);
  appendArc(arcs.second, path);
  return arcs.length();
}

NavigatorInfo doubleCurvatureInfo() {
  return describeNavigator<CurveNavigator::Params, DoubleCurvature>(
      "double-curvature", "two arcs through a point of inflection to the goal, avoids nothing",
      "Choi & Lee 2005, section III", curveParameters());
}

}  // namespace fulbito
