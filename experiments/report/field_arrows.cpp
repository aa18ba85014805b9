#include "experiments/report/field_arrows.hpp"

#include <algorithm>

namespace fulbito {
namespace {

constexpr double kAcross = 34.0;  // number of arrows along the longer side

bool onObstacle(const std::vector<DiscObstacle>& discs, Vec2 p) {
  return std::any_of(discs.begin(), discs.end(),
                     [p](const DiscObstacle& disc) { return distance(disc.position, p) < disc.radius; });
}

}  // namespace

double arrowSpacing(Vec2 low, Vec2 high) { return std::max(high.x - low.x, high.y - low.y) / kAcross; }

Result<std::vector<Pose2>> fieldArrows(const TrialConfig& config, Vec2 low, Vec2 high) {
  auto navigator = config.navigator.info->make(config.navigator.settings);
  if (!navigator) return tl::unexpected<Error>(navigator.error());
  std::vector<DiscObstacle> discs;
  for (const ObstacleSpec& spec : config.layout.obstacles) {
    appendDiscs(spec, {spec.pose, velocityAt(spec, 0.0)}, discs);
  }
  NavigationScene scene;
  scene.dt = config.physics.controlPeriod();
  scene.field = &config.field;
  scene.robot = &config.robot.robot;
  scene.self.pose = config.layout.start;
  scene.obstacles = discs;
  scene.goal = {config.layout.goal, config.layout.goal_heading, config.layout.goal_tolerance,
                config.layout.heading_tolerance, false};
  (*navigator)->reset();
  const Guidance guidance = (*navigator)->plan(scene);
  std::vector<Pose2> arrows;
  if (guidance.kind != GuidanceKind::kField || guidance.field == nullptr) return arrows;
  const double spacing = arrowSpacing(low, high);
  const int columns = static_cast<int>((high.x - low.x) / spacing),
            rows = static_cast<int>((high.y - low.y) / spacing);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec2 p = low + Vec2{column + 0.5, row + 0.5} * spacing;
      if (!insideField(config.field, p) || onObstacle(discs, p)) continue;
      arrows.push_back({p, guidance.field->heading(p)});
    }
  }
  return arrows;
}

}  // namespace fulbito
