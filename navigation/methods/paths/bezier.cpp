#include "navigation/methods/paths/bezier.hpp"

#include <array>
#include <limits>

#include "navigation/interface/parameters.hpp"

namespace fulbito {
namespace {

constexpr double kLeastClearance = 0.005;  // [m]

}  // namespace

Bezier::Bezier(Params params)
    : PathNavigator(params),
      clearance_(params.clearance),
      tangent_path_({.hysteresis = params.hysteresis}),
      planner_({.alpha = params.alpha, .all_sides = params.all_sides, .hysteresis = params.hysteresis}) {}

void Bezier::forget() { tangent_path_.reset(); }

void Bezier::makePath(const NavigationScene& scene, std::span<const Circle> bodies, std::vector<Vec2>& path) {
  ++counts_.plans;
  const bool blocked = tangent_path_.plan(scene, bodies) == TangentPath::Outcome::kNone;
  on_tangent_path_ = blocked || !findCurve(scene, bodies);
  if (!on_tangent_path_) {
    path.assign(planner_.path().begin(), planner_.path().end());
    return;
  }
  ++(blocked ? counts_.blocked : counts_.tangent);
  tangent_path_.sample(path);
}

double Bezier::speedCap(const NavigationScene& scene) const {
  return on_tangent_path_ ? tangent_path_.speedCap(scene) : std::numeric_limits<double>::infinity();
}

bool Bezier::findCurve(const NavigationScene& scene, std::span<const Circle> bodies) {
  std::array<double, BezierPlanner::kMostClearances> clearances{};
  std::size_t count = 0;
  clearances[count++] = clearance_;
  for (double less : {clearance_ / 2, kLeastClearance}) {
    if (less < clearances[count - 1] && less >= kLeastClearance) clearances[count++] = less;
  }
  const auto kept = planner_.plan(scene, bodies, tangent_path_, {clearances.data(), count});
  if (kept && *kept > 0) ++counts_.tight;
  return kept.has_value();
}

NavigatorInfo bezierInfo() {
  using P = Bezier::Params;
  return describeNavigator<P, Bezier>(
      "bezier", "the shortest Bezier curve round the obstacles that is clear of them",
      "Jung & Lee 2015, with a collision test",
      withPathParameters<P>(
          {number("clearance", &P::clearance, 0.0, 0.2, "m",
                  "distance kept from the robot's circumscribed circle"),
           number("alpha", &P::alpha, -0.5, 0.5, "m", "added to the length A = 3 r that selects obstacles"),
           flag("all_sides", &P::all_sides, "compare all choices of sides, not only the shortest path's"),
           number("hysteresis", &P::hysteresis, 0.0, 1.0, "",
                  "relative gain in length that makes the robot change sides")}));
}

}  // namespace fulbito
