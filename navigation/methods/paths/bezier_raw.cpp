#include "navigation/methods/paths/bezier_raw.hpp"

#include "navigation/geometry/polyline.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostObstacles = 8;
constexpr std::size_t kReserved = 64;

}  // namespace

// In Jung & Lee (2015) obstacles do not move.
BezierRaw::BezierRaw(Params params)
    : PathNavigator({.horizon = 0.0, .yield = 0.0, .replan = params.replan}), params_(params) {
  selected_.reserve(kReserved);
  kept_selected_.reserve(kReserved);
}

void BezierRaw::forget() {
  kept_selected_.clear();
  kept_sides_ = 0;
}

void BezierRaw::makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                         std::vector<Vec2>& path) {
  const Vec2 robot = scene.self.pose.position, goal = scene.goal.position;
  selectObstacles(robot, goal, bodies, params_.alpha, selected_);
  if (selected_.size() > kMostObstacles) selected_.resize(kMostObstacles);
  const std::uint32_t choices = 1U << selected_.size();
  double best = 0.0;
  std::uint32_t best_sides = choices;
  if (selected_ == kept_selected_) {
    best_sides = kept_sides_;
    best = curve(scene, bodies, best_sides, shortest_) * (1.0 - params_.hysteresis);
  }
  for (std::uint32_t sides = 0; sides < choices; ++sides) {
    const double length = curve(scene, bodies, sides, trial_);
    if (best_sides < choices && !(length < best)) continue;
    best = length;
    best_sides = sides;
    shortest_ = trial_;
  }
  kept_sides_ = best_sides;
  kept_selected_ = selected_;
  path.assign(shortest_.begin(), shortest_.end());
}

double BezierRaw::curve(const NavigationScene& scene, std::span<const Circle> bodies, std::uint32_t sides,
                        BezierSamples& out) const {
  std::array<Vec2, kMostObstacles + 2> control;
  std::size_t count = 0;
  control[count++] = scene.self.pose.position;
  for (std::size_t i = 0; i < selected_.size(); ++i) {
    const int side = (sides >> i & 1U) != 0 ? -1 : 1;
    control[count++] = controlPoint(scene.self.pose.position, bodies[selected_[i]].centre, side, params_.tbp);
  }
  control[count++] = scene.goal.position;
  sampleBezier({control.data(), count}, out);
  return polylineLength(out);
}

NavigatorInfo bezierRawInfo() {
  using P = BezierRaw::Params;
  return describeNavigator<P, BezierRaw>(
      "bezier-raw", "the Bezier curve of Jung & Lee as printed, without a collision test",
      "Jung & Lee 2015, sections 3-4, misprints mended",
      {number("tbp", &P::tbp, 0.0, 1.0, "m", "distance of a control point from its obstacle"),
       number("alpha", &P::alpha, -0.5, 0.5, "m", "added to the length A = 3 r that selects obstacles"),
       number("hysteresis", &P::hysteresis, 0.0, 1.0, "",
              "relative gain in length that makes the robot change sides"),
       replanParameter<P>()});
}

}  // namespace fulbito
