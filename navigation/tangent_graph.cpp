#include "navigation/tangent_graph.hpp"

#include <algorithm>

#include "navigation/yield_speed.hpp"

namespace fulbito {
namespace {

constexpr double kSpacing = 0.01;  // [m]
constexpr std::size_t kReservedPoints = 1024;

}  // namespace

TangentGraphNavigator::TangentGraphNavigator(Params params)
    : params_(params),
      tangent_path_({.margin = params.margin,
                     .hysteresis = params.hysteresis,
                     .approach = params.approach,
                     .bend = params.bend}) {
  path_.reserve(kReservedPoints);
}

void TangentGraphNavigator::reset() {
  tangent_path_.reset();
  monitor_.reset();
  blocked_ = false;
}

Guidance TangentGraphNavigator::plan(const NavigationScene& scene) {
  predictObstacles(scene, params_.horizon, bodies_);
  if (params_.replan == Replan::kTick || monitor_.due(scene, bodies_, path_)) {
    blocked_ = tangent_path_.plan(scene, bodies_) == TangentPath::Outcome::kNone;
    tangent_path_.sample(kSpacing, path_);
    monitor_.planned(scene, bodies_);
    ++revision_;
  }
  Guidance guidance;
  guidance.kind = GuidanceKind::kPath;
  guidance.path = path_;
  guidance.revision = revision_;
  guidance.stuck = blocked_;
  guidance.speed_cap = yieldSpeed(scene, path_, params_.yield);
  guidance.speed_cap = std::min(guidance.speed_cap, tangent_path_.speedCap(scene));
  return guidance;
}

NavigatorInfo tangentGraphInfo() {
  using P = TangentGraphNavigator::Params;
  return describeNavigator<P, TangentGraphNavigator>(
      "tangent-graph", "follows the exact shortest path among the obstacles' discs",
      "textbook (Latombe 1991), the anchor of paper 004's comparison",
      {number("margin", &P::margin, 0.0, 0.2, "m", "kept beside the robot's circumscribed circle"),
       number("hysteresis", &P::hysteresis, 0.0, 1.0, "", "share of the way that another side must save"),
       number("approach", &P::approach, 0.0, 0.5, "m", "straight before a goal with an arrival heading"),
       number("bend", &P::bend, 0.01, 0.5, "m", "radius of the turn onto that straight"),
       number("horizon", &P::horizon, 0.0, 2.0, "s", "farthest look ahead at moving obstacles"),
       number("yield", &P::yield, 0.0, 2.0, "s", "look ahead for slowing down before obstacles; 0 = never"),
       choice("replan", &P::replan, {"change", "tick"}, "when to plan again")});
}

}  // namespace fulbito
