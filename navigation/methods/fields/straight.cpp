#include "navigation/methods/fields/straight.hpp"

#include "fulbito/detail/math.hpp"

namespace fulbito {

Guidance Straight::plan(const NavigationScene& scene) {
  goal_ = scene.goal.position;
  return guidanceBy(*this);
}

double Straight::heading(Vec2 p) const { return math::angleOf(goal_ - p); }

NavigatorInfo straightInfo() {
  return describeNavigator<Straight::Params, Straight>(
      "straight", "drives straight to the goal, avoids nothing", "-", {});
}

}  // namespace fulbito
