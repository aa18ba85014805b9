// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Notes the tick's touches of ball and opponents.
void noteTouches(const DetectorInput& input, const PresenceMemory& presence, TouchMemory& touches);

/// Notes who came into the areas and who keeps each goal: the robot that has been longest inside its own goal
/// area; of several that came at once the keeper so far, else the first in the view. A robot that comes in
/// while it disputes the ball and was pushed toward the goal is excused for a while.
void notePresence(const DetectorInput& input, const TouchMemory& touches, PresenceMemory& presence);

/// The team's keeper, if it is on the field: number 0 until one is known.
std::optional<std::size_t> keeperOf(const DetectorInput& input, TeamId team, const PresenceMemory& presence);

/// Whether robot `i` of the view is its team's keeper and inside its own goal area.
bool keepsGoal(const DetectorInput& input, std::size_t i, const PresenceMemory& presence);

}  // namespace fulbito
