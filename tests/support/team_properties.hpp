#pragma once

#include <string>

namespace fulbito::test {

/// Which of the common properties a team promises, and how much of them is tried.
struct TeamProperties {
  int scenes = 40;         ///< random scenes per size of team and age of the pictures
  int ticks = 30;          ///< control ticks in each scene
  bool mirrored = true;    ///< a scene mirrored across the long axis gives the mirrored commands
  bool allocates = false;  ///< may allocate in `decide` even when warm
};

/// Checks what every team promises, with three and five robots, fresh and old pictures:
/// - commands are finite and name only navigators that the team has, and the navigation stage makes wheel
///   speeds within saturation of twists and places, in random and in degenerate scenes (nobody on the field,
///   one robot left, all bodies on one point, ball in a robot, in either goal or off the field, robots beyond
///   the walls, play that waits, every kind of restart);
/// - drawings come only where they are wanted, and are finite;
/// - two teams that see the same scenes give the same bits;
/// - mirrored scenes give mirrored commands (the other half of the field needs no check: a team sees its own
///   frame);
/// - no heap allocation in a decision once warm;
/// - no place proposed for a restart has to be repaired by the referee, on either side.
/// Its failures are those of the test case that calls it.
void checkTeamProperties(const std::string& specification, TeamProperties properties = {});

}  // namespace fulbito::test
