#pragma once

#include <string>

namespace fulbito::test {

/// Which of the common properties a method promises, and how much of them is tried.
struct NavigatorProperties {
  int scenes = 200;        ///< random scenes, 20 control ticks each
  int edge_ticks = 30;     ///< control ticks in each degenerate scene
  bool half_turn = true;   ///< a scene turned by 180 degrees gives the same first wheel speeds
  bool allocates = false;  ///< may allocate in a tick even when warm
};

/// Checks what every navigation method promises, on the pilot that `specification` makes:
/// - finite guidance and wheel speeds within saturation in degenerate scenes (goal inside an obstacle, robot
///   on the goal or on an obstacle's centre, coincident obstacles, robot at a wall or in a corner, none or 50
///   obstacles, moving obstacles, goal outside the field), with and without an arrival heading;
/// - the same in random scenes;
/// - two pilots that see the same scenes give the same bits;
/// - equivariance under a turn by 180 degrees;
/// - no heap allocation in a tick once warm.
/// Its failures are those of the test case that calls it.
void checkNavigatorProperties(const std::string& specification, NavigatorProperties properties = {});

}  // namespace fulbito::test
