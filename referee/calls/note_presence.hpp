#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Updates the touches of ball and opponents.
void noteTouches(const DetectorInput& input, const PresenceMemory& presence, TouchMemory& touches);

/// Updates the robots in the areas and the keeper of each goal: the robot that has been longest inside its
/// own goal area. If several entered at once, the present keeper stays, else the first in the view is it. A
/// robot that was pushed toward the goal and enters while it disputes the ball is excused for a while.
void notePresence(const DetectorInput& input, const TouchMemory& touches, PresenceMemory& presence);

/// The team's keeper, if it is on the field: robot 0 until another one is known.
std::optional<std::size_t> keeperOf(const DetectorInput& input, TeamId team, const PresenceMemory& presence);

/// Whether robot `i` of the view is its team's keeper and inside its own goal area.
bool keepsGoal(const DetectorInput& input, std::size_t i, const PresenceMemory& presence);

}  // namespace fulbito
