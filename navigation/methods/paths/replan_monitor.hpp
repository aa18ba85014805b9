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

/// Tells a path navigator when its path is out of date: an obstacle appeared, left or is more than 2 mm from
/// its place in the plan, the goal changed, or the robot is more than 2 cm off the path. Obstacles are
/// identified by their order in the scene.
class ReplanMonitor {
 public:
  void reset() { known_ = false; }
  /// @param obstacles  as a new plan would use them
  bool due(const NavigationScene& scene, std::span<const Circle> obstacles, std::span<const Vec2> path) const;
  /// Stores the conditions of the present path.
  void planned(const NavigationScene& scene, std::span<const Circle> obstacles);

 private:
  bool known_ = false;
  Vec2 goal_;
  std::optional<double> heading_;
  std::vector<Circle> obstacles_;
};

}  // namespace fulbito
