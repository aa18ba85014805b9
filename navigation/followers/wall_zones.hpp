#pragma once

#include <optional>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// The boundary rule of Jung & Lee (2015), section 2.1, Figs 4-5: near a wall the two wheels get unequal
/// speeds toward the ball, whatever the robot's heading; in a corner the zones of two walls act one after the
/// other. It replaces what the follower wants while the robot's centre is in a zone.
///
/// The paper names neither the sense of turning nor the end that leads. Its robot drives both ways, so the
/// end that looks off the wall leads, and the rule needs no heading for the sense: it turns the wall's inward
/// normal to the goal. In the upper left corner, with the goal to the lower right, that is clockwise at the
/// left wall and counter-clockwise at the upper one: Fig. 5's.
///
/// Ours: depth of the zone and speeds, which are those of programs of that time (docs/followers.md). The zone
/// that acts is the nearest wall's, until the robot leaves it.
class WallZones {
 public:
  void reset() { wall_.reset(); }
  /// `wanted` of the follower, or the rule's own twist.
  Twist apply(const NavigationScene& scene, Twist wanted);
  bool active() const { return wall_.has_value(); }

 private:
  std::optional<std::size_t> wall_;  ///< whose zone acts, see `nearWalls`
};

}  // namespace fulbito
