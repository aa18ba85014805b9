#pragma once

#include <optional>
#include <span>
#include <string>

#include "fulbito/match.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// Where all of a world stand.
Placement placementOf(const WorldState& world, std::span<const RobotId> ids);

/// What a user's placement in the middle of a match must not be, in words such as "blue robot 1 would overlap
/// a robot". Only what differs from `before` is judged: who leans on another or stands in a goal may stay. A
/// body that was moved must be on the field, the ball not in a goal, clear of all others; a moving ball must
/// have a finite speed of at most 50 m/s; no robot may be added or left out.
std::optional<std::string> flawOfEdit(const MatchConfig& config, const Placement& before,
                                      const Placement& after);

/// How play goes on from a user's placement: at once, in the name of the team that took the last restart.
RestartCall editCall(const RefereeState& referee, const Placement& placement);

}  // namespace fulbito
