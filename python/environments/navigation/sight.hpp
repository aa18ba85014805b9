#pragma once

#include <span>
#include <string>
#include <vector>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// One number of an observation.
struct NavigationSightEntry {
  std::string name;
  std::string unit;  ///< empty: a share or a direction
  std::string meaning;
};

/// Numbers lie within -kNavigationSightBound ... kNavigationSightBound.
inline constexpr float kNavigationSightBound = 4.0f;

/// All numbers of an observation, in their order.
const std::vector<NavigationSightEntry>& navigationSight();

/// What a navigator knows, as numbers in its robot's frame: where the goal is, how it drives, how far it is
/// to the nearest thing in 32 directions, and the nearest obstacles with their velocities.
class NavigationSight {
 public:
  /// Writes `navigationSight().size()` numbers. Allocates nothing unless the field changes.
  void write(const NavigationScene& scene, std::span<float> out);

 private:
  const FieldGeometry* field_ = nullptr;
  std::vector<Vec2> contour_;  ///< of that field
};

}  // namespace fulbito
