#include "navigation/methods/paths/replan_monitor.hpp"

#include "navigation/geometry/polyline.hpp"

namespace fulbito {
namespace {

constexpr double kMoved = 0.002;   // [m]
constexpr double kStrayed = 0.02;  // [m]

}  // namespace

bool ReplanMonitor::due(const NavigationScene& scene, std::span<const Circle> obstacles,
                        std::span<const Vec2> path) const {
  if (!known_ || obstacles.size() != obstacles_.size()) return true;
  if (scene.goal.heading != heading_ || distance(scene.goal.position, goal_) > kMoved) return true;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (obstacles[i].radius != obstacles_[i].radius) return true;
    if (squaredNorm(obstacles[i].centre - obstacles_[i].centre) > kMoved * kMoved) return true;
  }
  return distanceToPath(path, scene.self.pose.position) > kStrayed;
}

void ReplanMonitor::planned(const NavigationScene& scene, std::span<const Circle> obstacles) {
  known_ = true;
  goal_ = scene.goal.position;
  heading_ = scene.goal.heading;
  obstacles_.assign(obstacles.begin(), obstacles.end());
}

}  // namespace fulbito
