#pragma once

#include <optional>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// The boundary rule of Jung & Lee (2015), section 2.1, Figs 4-5. Near a wall the two wheels get unequal
/// speeds toward the ball, whatever the robot's heading. In a corner the zones of the two walls act one after
/// the other. The rule replaces the follower's twist while the robot's centre is in a zone.
///
/// The paper specifies neither the sense of turning nor the leading end. Here the end that points away from
/// the wall leads, and the sense turns the wall's inward normal toward the goal, independent of the heading.
/// In the upper left corner with the goal to the lower right, that is clockwise at the left wall and
/// counter-clockwise at the upper wall, as in Fig. 5.
///
/// Not from the paper: the depth of the zone and the speeds, which are typical of programs of that time
/// (docs/followers.md). The zone of the nearest wall acts until the robot leaves it.
class WallZones {
 public:
  void reset() { wall_.reset(); }
  /// Returns the follower's twist `wanted`, or the rule's own twist.
  Twist apply(const NavigationScene& scene, Twist wanted);
  bool active() const { return wall_.has_value(); }

 private:
  std::optional<std::size_t> wall_;  ///< index of the wall whose zone acts, see `nearWalls`
};

}  // namespace fulbito
