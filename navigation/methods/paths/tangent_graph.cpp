#include "navigation/methods/paths/tangent_graph.hpp"

#include "navigation/interface/parameters.hpp"

namespace fulbito {

TangentGraphNavigator::TangentGraphNavigator(Params params)
    : PathNavigator(params),
      tangent_path_({.margin = params.margin,
                     .hysteresis = params.hysteresis,
                     .approach = params.approach,
                     .bend = params.bend}) {}

void TangentGraphNavigator::forget() { tangent_path_.reset(); }

void TangentGraphNavigator::makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                                     std::vector<Vec2>& path) {
  tangent_path_.plan(scene, bodies);
  tangent_path_.sample(path);
}

double TangentGraphNavigator::speedCap(const NavigationScene& scene) const {
  return tangent_path_.speedCap(scene);
}

NavigatorInfo tangentGraphInfo() {
  using P = TangentGraphNavigator::Params;
  return describeNavigator<P, TangentGraphNavigator>(
      "tangent-graph", "follows the exact shortest path among the obstacles' discs",
      "textbook: Latombe 1991, chapter 4",
      withPathParameters<P>(
          {number("margin", &P::margin, 0.0, 0.2, "m", "distance kept from the robot's circumscribed circle"),
           number("hysteresis", &P::hysteresis, 0.0, 1.0, "",
                  "relative gain in length that makes the robot change sides"),
           number("approach", &P::approach, 0.0, 0.5, "m",
                  "straight length before a goal with an arrival heading"),
           number("bend", &P::bend, 0.01, 0.5, "m", "radius of the turn onto that straight")}));
}

}  // namespace fulbito
