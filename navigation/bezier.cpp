#include "navigation/bezier.hpp"

#include <algorithm>
#include <array>

#include "navigation/yield_speed.hpp"

namespace fulbito {
namespace {

constexpr double kLeastClearance = 0.005;  // [m]
constexpr double kSpacing = 0.01;          // [m] of a tangent graph path
constexpr std::size_t kReservedPoints = 1024;

}  // namespace

Bezier::Bezier(Params params)
    : params_(params),
      tangent_path_({.hysteresis = params.hysteresis}),
      planner_({.alpha = params.alpha, .all_sides = params.all_sides, .hysteresis = params.hysteresis}) {
  path_.reserve(kReservedPoints);
}

void Bezier::reset() {
  tangent_path_.reset();
  monitor_.reset();
  blocked_ = on_tangent_path_ = false;
}

Guidance Bezier::plan(const NavigationScene& scene) {
  predictObstacles(scene, params_.horizon, bodies_);
  if (params_.replan == Replan::kTick || monitor_.due(scene, bodies_, path_)) {
    replan(scene);
    monitor_.planned(scene, bodies_);
    ++revision_;
  }
  Guidance guidance;
  guidance.kind = GuidanceKind::kPath;
  guidance.path = path_;
  guidance.revision = revision_;
  guidance.stuck = blocked_;
  guidance.speed_cap = yieldSpeed(scene, path_, params_.yield);
  if (on_tangent_path_) guidance.speed_cap = std::min(guidance.speed_cap, tangent_path_.speedCap(scene));
  return guidance;
}

void Bezier::replan(const NavigationScene& scene) {
  ++counts_.plans;
  blocked_ = tangent_path_.plan(scene, bodies_) == TangentPath::Outcome::kNone;
  on_tangent_path_ = blocked_ || !findCurve(scene);
  if (!on_tangent_path_) {
    path_.assign(planner_.path().begin(), planner_.path().end());
    return;
  }
  ++(blocked_ ? counts_.blocked : counts_.tangent);
  tangent_path_.sample(kSpacing, path_);
}

bool Bezier::findCurve(const NavigationScene& scene) {
  std::array<double, BezierPlanner::kMostClearances> clearances{};
  std::size_t count = 0;
  clearances[count++] = params_.clearance;
  for (double less : {params_.clearance / 2, kLeastClearance}) {
    if (less < clearances[count - 1] && less >= kLeastClearance) clearances[count++] = less;
  }
  const auto kept = planner_.plan(scene, bodies_, tangent_path_, {clearances.data(), count});
  if (kept && *kept > 0) ++counts_.tight;
  return kept.has_value();
}

NavigatorInfo bezierInfo() {
  using P = Bezier::Params;
  return describeNavigator<P, Bezier>(
      "bezier", "the shortest Bezier curve round the obstacles that is clear of them",
      "paper 004, with a collision test",
      {number("clearance", &P::clearance, 0.0, 0.2, "m", "kept beside the robot's circumscribed circle"),
       number("alpha", &P::alpha, -0.5, 0.5, "m", "added to the length A = 3 r that selects obstacles"),
       flag("all_sides", &P::all_sides, "compare all choices of sides, not only the shortest path's"),
       number("hysteresis", &P::hysteresis, 0.0, 1.0, "", "share by which other sides must be shorter"),
       number("horizon", &P::horizon, 0.0, 2.0, "s", "farthest look ahead at moving obstacles"),
       number("yield", &P::yield, 0.0, 2.0, "s", "look ahead for slowing down before obstacles; 0 = never"),
       choice("replan", &P::replan, {"change", "tick"}, "when to plan again")});
}

}  // namespace fulbito
