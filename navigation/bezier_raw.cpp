#include "navigation/bezier_raw.hpp"

#include "navigation/path_problem.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostObstacles = 8;
constexpr std::size_t kReserved = 64;

}  // namespace

BezierRaw::BezierRaw(Params params) : params_(params) {
  obstacles_.reserve(kReserved);
  selected_.reserve(kReserved);
  kept_selected_.reserve(kReserved);
}

void BezierRaw::reset() {
  monitor_.reset();
  kept_selected_.clear();
  kept_sides_ = 0;
}

Guidance BezierRaw::plan(const NavigationScene& scene) {
  predictObstacles(scene, 0.0, obstacles_);  // the paper's obstacles stand still
  if (params_.replan == Replan::kTick || monitor_.due(scene, obstacles_, path_)) {
    choose(scene);
    monitor_.planned(scene, obstacles_);
    ++revision_;
  }
  Guidance guidance;
  guidance.kind = GuidanceKind::kPath;
  guidance.path = path_;
  guidance.revision = revision_;
  return guidance;
}

void BezierRaw::choose(const NavigationScene& scene) {
  const Vec2 robot = scene.self.pose.position, goal = scene.goal.position;
  selectObstacles(robot, goal, obstacles_, params_.alpha, selected_);
  if (selected_.size() > kMostObstacles) selected_.resize(kMostObstacles);
  const std::uint32_t choices = 1U << selected_.size();
  double best = 0.0;
  std::uint32_t best_sides = choices;
  if (selected_ == kept_selected_) {
    best_sides = kept_sides_;
    best = curve(scene, best_sides, path_) * (1.0 - params_.hysteresis);
  }
  for (std::uint32_t sides = 0; sides < choices; ++sides) {
    const double length = curve(scene, sides, trial_);
    if (best_sides < choices && !(length < best)) continue;
    best = length;
    best_sides = sides;
    path_ = trial_;
  }
  kept_sides_ = best_sides;
  kept_selected_ = selected_;
}

double BezierRaw::curve(const NavigationScene& scene, std::uint32_t sides, BezierSamples& out) const {
  std::array<Vec2, kMostObstacles + 2> control;
  std::size_t count = 0;
  control[count++] = scene.self.pose.position;
  for (std::size_t i = 0; i < selected_.size(); ++i) {
    const int side = (sides >> i & 1U) != 0 ? -1 : 1;
    control[count++] =
        controlPoint(scene.self.pose.position, obstacles_[selected_[i]].centre, side, params_.tbp);
  }
  control[count++] = scene.goal.position;
  sampleBezier({control.data(), count}, out);
  return polylineLength(out);
}

NavigatorInfo bezierRawInfo() {
  using P = BezierRaw::Params;
  return describeNavigator<P, BezierRaw>(
      "bezier-raw", "paper 004's Bezier curve as printed, without a collision test",
      "paper 004, errata E24-E26, E28",
      {number("tbp", &P::tbp, 0.0, 1.0, "m", "distance of a control point from its obstacle"),
       number("alpha", &P::alpha, -0.5, 0.5, "m", "added to the length A = 3 r that selects obstacles"),
       number("hysteresis", &P::hysteresis, 0.0, 1.0, "", "share by which other sides must be shorter"),
       choice("replan", &P::replan, {"change", "tick"}, "when to plan again")});
}

}  // namespace fulbito
