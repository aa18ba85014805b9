#include "navigation/hermite.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/math.hpp"
#include "navigation/yield_speed.hpp"

namespace fulbito {
namespace {

constexpr double kSpacing = 0.01;  // [m]
constexpr std::size_t kReservedPoints = 1024, kReservedJoints = 34;
constexpr double kMostPieces = 2000.0;
constexpr double kInMotion = 0.15;  // [m/s] above which a curve starts along the motion
constexpr std::array<double, 6> kExtras = {0.0, 0.004, 0.008, 0.014, 0.024, 0.040};  // [m]

}  // namespace

void appendHermite(Vec2 a, Vec2 da, Vec2 b, Vec2 db, double spacing, std::vector<Vec2>& out) {
  const double pieces = std::clamp(std::floor(distance(a, b) / spacing) + 1.0, 8.0, kMostPieces);
  for (double i = 1.0; i < pieces; i += 1.0) {
    const double t = i / pieces, s = 1.0 - t;
    out.push_back(a * (s * s * (1.0 + 2.0 * t)) + da * (s * s * t) + b * (t * t * (1.0 + 2.0 * s)) -
                  db * (t * t * s));
  }
  out.push_back(b);
}

Hermite::Hermite(Params params)
    : params_(params), tangent_path_({.margin = params.clearance, .hysteresis = params.hysteresis}) {
  path_.reserve(kReservedPoints);
  joints_.reserve(kReservedJoints);
}

void Hermite::reset() {
  tangent_path_.reset();
  monitor_.reset();
  blocked_ = on_tangent_path_ = false;
}

Guidance Hermite::plan(const NavigationScene& scene) {
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

void Hermite::replan(const NavigationScene& scene) {
  ++counts_.plans;
  blocked_ = on_tangent_path_ = false;
  guard_.prepare(scene.self.pose.position, scene.goal.position, bodies_, scene.robot->circumradius(),
                 params_.clearance, *scene.field);
  for (double extra : kExtras) {
    const auto outcome = tangent_path_.plan(scene, bodies_, extra);
    // Anything else is a corner, or a way that is narrow or that wider circles have closed.
    if (outcome != TangentPath::Outcome::kFound) break;
    placeJoints(scene);
    drawCurve();
    if (guard_.clear(path_) && guard_.insideWalls(path_)) return;
  }
  on_tangent_path_ = true;
  blocked_ = tangent_path_.plan(scene, bodies_) == TangentPath::Outcome::kNone;
  ++(blocked_ ? counts_.blocked : counts_.tangent);
  tangent_path_.sample(kSpacing, path_);
}

void Hermite::placeJoints(const NavigationScene& scene) {
  const Vec2 start = scene.self.pose.position, goal = scene.goal.position;
  joints_.clear();
  joints_.push_back({start, {}});
  for (const CirclePass& pass : tangent_path_.passes()) {
    const Vec2 centre = tangent_path_.centreOf(pass), spoke = pass.entry - centre;
    const double side = static_cast<double>(pass.side);
    const math::SinCos half = math::sinCos(side * pass.sweep / 2);
    const Vec2 middle = spoke * half.cos + perp(spoke) * half.sin;
    joints_.push_back({centre + middle, perp(unitOr(middle, {1.0, 0.0})) * side});
  }
  if (!(tangent_path_.target() == goal)) {
    joints_.push_back({tangent_path_.target(), math::unit(*scene.goal.heading)});
  }
  joints_.push_back({goal, {}});
  const Vec2 facing = math::unit(scene.self.pose.heading);
  const bool moves = dot(scene.self.velocity, facing) > kInMotion;
  Joint &first = joints_.front(), &last = joints_.back();
  const Joint &second = joints_[1], &before = joints_[joints_.size() - 2];
  // A free end takes the direction that makes the curvature vanish there, or nearly so.
  const Vec2 out = unitOr(second.place - first.place, facing), in = unitOr(last.place - before.place, facing);
  first.direction = moves ? facing : unitOr(out * 3.0 - second.direction, out);
  last.direction =
      scene.goal.heading ? math::unit(*scene.goal.heading) : unitOr(in * 3.0 - before.direction, in);
}

void Hermite::drawCurve() {
  path_.clear();
  path_.push_back(joints_.front().place);
  for (std::size_t i = 1; i < joints_.size(); ++i) {
    const Joint &a = joints_[i - 1], &b = joints_[i];
    const double size = params_.tension * distance(a.place, b.place);
    appendHermite(a.place, a.direction * size, b.place, b.direction * size, kSpacing, path_);
  }
}

NavigatorInfo hermiteInfo() {
  using P = Hermite::Params;
  return describeNavigator<P, Hermite>(
      "hermite", "cubic Hermite segments through the shortest path's bends",
      "paper 004's future work, cubic Hermite interpolation",
      {number("clearance", &P::clearance, 0.0, 0.2, "m", "kept beside the robot's circumscribed circle"),
       number("tension", &P::tension, 0.1, 2.0, "", "length of the joints' derivatives over the chord"),
       number("hysteresis", &P::hysteresis, 0.0, 1.0, "", "share of the way that another side must save"),
       number("horizon", &P::horizon, 0.0, 2.0, "s", "farthest look ahead at moving obstacles"),
       number("yield", &P::yield, 0.0, 2.0, "s", "look ahead for slowing down before obstacles; 0 = never"),
       choice("replan", &P::replan, {"change", "tick"}, "when to plan again")});
}

}  // namespace fulbito
