#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fulbito/navigation.hpp"
#include "navigation/geometry/circle.hpp"

namespace fulbito {

/// When a path navigator plans.
enum class Replan {
  kChange,  ///< when the scene has changed or the robot strays
  kTick,    ///< at every control tick
};

/// Tells a path navigator when its path is out of date: an obstacle appeared, left or is expected more than
/// 2 mm from where it was planned with, the goal changed, or the robot is more than 2 cm off the path.
/// Obstacles are told apart by their order in the scene.
class ReplanMonitor {
 public:
  void reset() { known_ = false; }
  /// @param obstacles  as they would be planned with now
  bool due(const NavigationScene& scene, std::span<const Circle> obstacles, std::span<const Vec2> path) const;
  /// Notes what the path in use was planned with.
  void planned(const NavigationScene& scene, std::span<const Circle> obstacles);

 private:
  bool known_ = false;
  Vec2 goal_;
  std::optional<double> heading_;
  std::vector<Circle> obstacles_;
};

}  // namespace fulbito
