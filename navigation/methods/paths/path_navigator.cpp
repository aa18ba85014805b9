#include "navigation/methods/paths/path_navigator.hpp"

#include <algorithm>
#include <limits>

#include "navigation/followers/yield_speed.hpp"
#include "navigation/obstacles/path_problem.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kReservedPoints = 1024;

}  // namespace

PathNavigator::PathNavigator(PathNavigatorParams params) : params_(params) { path_.reserve(kReservedPoints); }

void PathNavigator::reset() {
  monitor_.reset();
  forget();
}

Guidance PathNavigator::plan(const NavigationScene& scene) {
  predictObstacles(scene, params_.horizon, bodies_);
  if (params_.replan == Replan::kTick || monitor_.due(scene, bodies_, path_)) {
    makePath(scene, bodies_, path_);
    monitor_.planned(scene, bodies_);
    ++revision_;
  }
  Guidance guidance;
  guidance.kind = GuidanceKind::kPath;
  guidance.path = path_;
  guidance.revision = revision_;
  guidance.speed_cap = std::min(yieldSpeed(scene, path_, params_.yield), speedCap(scene));
  return guidance;
}

double PathNavigator::speedCap(const NavigationScene&) const {
  return std::numeric_limits<double>::infinity();
}

}  // namespace fulbito
