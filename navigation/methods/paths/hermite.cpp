#include "navigation/methods/paths/hermite.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {
namespace {

constexpr double kSpacing = 0.01;  // [m]
constexpr std::size_t kReservedJoints = 34;
constexpr double kMostPieces = 2000.0;
constexpr double kInMotion = 0.15;  // [m/s] the curve of a faster robot starts along its motion
// [m] growth of the circles of the shortest path
constexpr std::array<double, 6> kExtras = {0.0, 0.004, 0.008, 0.014, 0.024, 0.040};

}  // namespace

void appendHermite(Vec2 a, Vec2 da, Vec2 b, Vec2 db, double spacing, std::vector<Vec2>& out) {
  const double pieces = std::clamp(std::floor(distance(a, b) / spacing) + 1.0, 8.0, kMostPieces);
  for (int i = 1; i < pieces; ++i) {
    const double t = i / pieces, s = 1.0 - t;
    out.push_back(a * (s * s * (1.0 + 2.0 * t)) + da * (s * s * t) + b * (t * t * (1.0 + 2.0 * s)) -
                  db * (t * t * s));
  }
  out.push_back(b);
}

Hermite::Hermite(Params params)
    : PathNavigator(params),
      clearance_(params.clearance),
      tension_(params.tension),
      tangent_path_({.margin = params.clearance, .hysteresis = params.hysteresis}) {
  joints_.reserve(kReservedJoints);
}

void Hermite::forget() { tangent_path_.reset(); }

void Hermite::makePath(const NavigationScene& scene, std::span<const Circle> bodies,
                       std::vector<Vec2>& path) {
  ++counts_.plans;
  on_tangent_path_ = false;
  guard_.prepare(scene.self.pose.position, scene.goal.position, bodies, scene.robot->circumradius(),
                 clearance_, *scene.field);
  for (double extra : kExtras) {
    const auto outcome = tangent_path_.plan(scene, bodies, extra);
    // Other outcomes have a corner or a narrow way, or the wider circles have closed the way.
    if (outcome != TangentPath::Outcome::kFound) break;
    placeJoints(scene);
    drawCurve(path);
    if (guard_.clear(path) && guard_.insideWalls(path)) return;
  }
  on_tangent_path_ = true;
  const bool blocked = tangent_path_.plan(scene, bodies) == TangentPath::Outcome::kNone;
  ++(blocked ? counts_.blocked : counts_.tangent);
  tangent_path_.sample(path);
}

double Hermite::speedCap(const NavigationScene& scene) const {
  return on_tangent_path_ ? tangent_path_.speedCap(scene) : std::numeric_limits<double>::infinity();
}

void Hermite::placeJoints(const NavigationScene& scene) {
  const Vec2 start = scene.self.pose.position, goal = scene.goal.position;
  joints_.clear();
  joints_.push_back({start, {}});
  for (const CirclePass& pass : tangent_path_.passes()) {
    const Vec2 centre = tangent_path_.centreOf(pass), spoke = pass.entry - centre;
    const double side = static_cast<double>(pass.side);
    const Vec2 middle = outOfFrame(spoke, math::unit(side * pass.sweep / 2));
    joints_.push_back({centre + middle, perp(unitOr(middle, {1.0, 0.0})) * side});
  }
  if (scene.goal.heading && !(tangent_path_.target() == goal)) {
    joints_.push_back({tangent_path_.target(), math::unit(*scene.goal.heading)});
  }
  joints_.push_back({goal, {}});
  const Vec2 facing = math::unit(scene.self.pose.heading);
  const bool moves = dot(scene.self.velocity, facing) > kInMotion;
  Joint &first = joints_.front(), &last = joints_.back();
  const Joint &second = joints_[1], &before = joints_[joints_.size() - 2];
  // A free end gets the direction that makes the curvature there about zero.
  const Vec2 out = unitOr(second.place - first.place, facing), in = unitOr(last.place - before.place, facing);
  first.direction = moves ? facing : unitOr(out * 3.0 - second.direction, out);
  last.direction =
      scene.goal.heading ? math::unit(*scene.goal.heading) : unitOr(in * 3.0 - before.direction, in);
}

void Hermite::drawCurve(std::vector<Vec2>& path) const {
  path.clear();
  path.push_back(joints_.front().place);
  for (std::size_t i = 1; i < joints_.size(); ++i) {
    const Joint &a = joints_[i - 1], &b = joints_[i];
    const double size = tension_ * distance(a.place, b.place);
    appendHermite(a.place, a.direction * size, b.place, b.direction * size, kSpacing, path);
  }
}

NavigatorInfo hermiteInfo() {
  using P = Hermite::Params;
  return describeNavigator<P, Hermite>(
      "hermite", "cubic Hermite segments through the shortest path's bends",
      "cubic Hermite interpolation, future work of Jung & Lee 2015",
      withPathParameters<P>(
          {number("clearance", &P::clearance, 0.0, 0.2, "m",
                  "distance kept from the robot's circumscribed circle"),
           number("tension", &P::tension, 0.1, 2.0, "", "length of the joints' derivatives over the chord"),
           number("hysteresis", &P::hysteresis, 0.0, 1.0, "",
                  "relative gain in length that makes the robot change sides")}));
}

}  // namespace fulbito
