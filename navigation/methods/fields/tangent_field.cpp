#include "navigation/methods/fields/tangent_field.hpp"

#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {

Guidance TangentField::plan(const NavigationScene& scene) {
  goal_.aim(scene.goal);
  circles_.begin(scene.obstacles.size());
  for (const DiscObstacle& o : scene.obstacles) {
    circles_.add({o.position, std::max(1e-3, params_.offset + extraSize(o, *scene.robot))});
  }
  circles_.join();
  circles_.decideSides(scene.self.pose.position, scene.goal.position, {.hysteresis = params_.hysteresis});
  return guidanceBy(*this);
}

double TangentField::heading(Vec2 p) const {
  const Vec2 goal = goal_.goal();
  const std::size_t blocking = circles_.nearestBlocking(p, goal, params_.range);
  if (blocking == ClusteredCircles::kNone) return goal_.heading(p);
  const Extents turn = circles_.extents(blocking, p, goal);
  const double bearing = math::angleOf(goal - p);
  const bool left = circles_.side(blocking, p, goal) == PassingSide::kLeft;
  return math::wrapAngle(left ? bearing + turn.left : bearing - turn.right);
}

NavigatorInfo tangentFieldInfo() {
  using P = TangentField::Params;
  return describeNavigator<P, TangentField>(
      "tangent-field", "tangents of circles around the obstacles in the way",
      "textbook rule; strong baseline of the fields",
      withGoalFieldParameters<P>(
          {number("offset", &P::offset, 0.01, 1.0, "m", "radius of the circle around a ball-sized obstacle"),
           number("range", &P::range, 0.0, 10.0, "m",
                  "obstacles whose centre is farther away have no effect"),
           number("hysteresis", &P::hysteresis, 0.0, 3.0, "rad",
                  "advantage that makes the robot change sides")}));
}

}  // namespace fulbito
