#include "navigation/methods/curvature/curve_navigator.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {
namespace {

constexpr double kSpacing = 0.01;      // [m] between points of a curve
constexpr double kLeastTurn = 0.1;     // [rad] greatest turn between points of a tight curve
constexpr double kMostPieces = 400.0;  // greatest number of pieces of an arc
constexpr std::size_t kReserved = 1024;

/// Whether the path keeps half the robot's width from the walls, or the distance that the path has at its
/// ends.
bool staysInside(const std::vector<Vec2>& path, const NavigationScene& scene) {
  const auto room = [&](Vec2 p) {
    return std::min(scene.field->length / 2 - std::abs(p.x), scene.field->width / 2 - std::abs(p.y));
  };
  const double least =
      std::min({scene.robot->circumradius(), room(path.front()), room(scene.goal.position)}) - 1e-6;
  return std::all_of(path.begin(), path.end(), [&](Vec2 p) { return room(p) >= least; });
}

}  // namespace

void appendArc(const Arc& arc, std::vector<Vec2>& out) {
  const double spacing = std::min(kSpacing, kLeastTurn / std::max(std::abs(arc.curvature), 1e-9));
  const double pieces = std::clamp(std::ceil(arc.length / spacing), 1.0, kMostPieces);
  for (int i = 1; i <= static_cast<int>(pieces); ++i) {
    out.push_back(poseAt(arc, arc.length * i / pieces).position);
  }
}

CurveNavigator::CurveNavigator(Params params) : params_(params) { path_.reserve(kReserved); }

void CurveNavigator::reset() {
  monitor_.reset();
  forget();
}

Guidance CurveNavigator::plan(const NavigationScene& scene) {
  if (monitor_.due(scene, {}, path_)) {
    makePath(scene);
    monitor_.planned(scene, {});
    ++revision_;
  }
  Guidance guidance;
  guidance.kind = GuidanceKind::kPath;
  guidance.path = path_;
  guidance.revision = revision_;
  return guidance;
}

void CurveNavigator::makePath(const NavigationScene& scene) {
  const Vec2 start = scene.self.pose.position, goal = scene.goal.position;
  path_.assign(1, start);
  const double length = makeCurve(scene, path_);
  const bool drives = length <= params_.detour * distance(start, goal) && path_.size() > 1;
  if (drives && staysInside(path_, scene)) return;
  path_.assign({start, goal});
}

std::vector<Parameter<CurveNavigator::Params>> curveParameters() {
  using P = CurveNavigator::Params;
  return {number("detour", &P::detour, 1.0, 20.0, "",
                 "longest curve over the straight distance; beyond it the robot turns on the spot first")};
}

}  // namespace fulbito
