#include "navigation/methods/curvature/single_curvature.hpp"

#include <cmath>

namespace fulbito {

double SingleCurvature::makeCurve(const NavigationScene& scene, std::vector<Vec2>& path) {
  const Arc arc = arcThrough(scene.self.pose, scene.goal.position);
  if (std::isfinite(arc.length)) appendArc(arc, path);
  return arc.length;
}

NavigatorInfo singleCurvatureInfo() {
  return describeNavigator<CurveNavigator::Params, SingleCurvature>(
      "single-curvature", "one arc of a circle to the goal, avoids nothing", "Choi & Lee 2005, section III",
      curveParameters());
}

}  // namespace fulbito
