#include "navigation/methods/fields/vector_field.hpp"

#include <algorithm>

#include "navigation/geometry/angles.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {

Guidance VectorField::plan(const NavigationScene& scene) {
  goal_.aim(scene.goal);
  rings_.clear();
  for (const DiscObstacle& o : scene.obstacles) {
    rings_.push_back({o.position, params_.offset + extraSize(o, *scene.robot)});
  }
  return guidanceBy(*this);
}

double VectorField::heading(Vec2 p) const {
  const double to_goal = goal_.heading(p);
  const Circle* nearest = nullptr;
  double least = params_.width;  // [m] from the ring's inner edge; obstacles farther away do not act
  for (const Circle& ring : rings_) {
    const double outside = distance(p, ring.centre) - ring.radius;
    if (outside < least) least = outside, nearest = &ring;
  }
  if (nearest == nullptr) return to_goal;
  const double away = p == nearest->centre ? to_goal : math::angleOf(p - nearest->centre);
  return least <= 0.0 ? away : blendAngle(to_goal, away, 1.0 - least / params_.width);
}

NavigatorInfo vectorFieldInfo() {
  using P = VectorField::Params;
  return describeNavigator<P, VectorField>(
      "vector-field", "repulsive ring about the nearest obstacle", "Jung & Lee 2015, Figs 1-2",
      withGoalFieldParameters<P>(
          {number("offset", &P::offset, 0.0, 1.0, "m",
                  "distance from a ball-sized obstacle's centre up to which the field points straight away"),
           number("width", &P::width, 0.0, 1.0, "m", "width of the transition to the goal field")}));
}

}  // namespace fulbito
