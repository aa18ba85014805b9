#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fulbito/navigation.hpp"
#include "python/environments/sight.hpp"

namespace fulbito {

/// @{ Parts of an observation.
namespace navigation_sight {
inline constexpr std::size_t kOwnNumbers = 13;
inline constexpr std::size_t kRays = 32;
inline constexpr double kFarthest = 1.5;  // [m] a ray ends there
inline constexpr std::size_t kDiscs = 4;
inline constexpr std::size_t kDiscNumbers = 6;
inline constexpr std::size_t kSonars = 8;
}  // namespace navigation_sight
/// @}

/// Numbers of an observation. All lie within -kSightBound ... kSightBound.
inline constexpr std::size_t kNavigationSightNumbers =
    navigation_sight::kOwnNumbers + navigation_sight::kRays +
    navigation_sight::kDiscs * navigation_sight::kDiscNumbers + navigation_sight::kSonars;

/// All numbers of an observation, in their order.
const std::vector<SightEntry>& navigationSight();

/// What a navigator knows, as numbers in its robot's frame: where the goal is, how it drives, how far it is
/// to the nearest thing in 32 directions, and the nearest obstacles with their velocities.
class NavigationSight {
 public:
  /// Writes `kNavigationSightNumbers` numbers. Allocates nothing unless the field changes.
  void write(const NavigationScene& scene, std::span<float> out);

 private:
  const FieldGeometry* field_ = nullptr;
  std::vector<Vec2> contour_;  ///< of that field
};

}  // namespace fulbito
