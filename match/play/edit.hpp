#pragma once

#include <optional>
#include <span>
#include <string>

#include "fulbito/match.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// The poses of all robots of a world, and its ball.
Placement placementOf(const WorldState& world, std::span<const RobotId> ids);

/// The flaw of a user's placement during a match, in words such as "blue robot 1 would overlap a robot";
/// empty if it has none. Only differences from `before` count: bodies that already touch or stand in a goal
/// may stay. A moved body must be on the field and clear of all others, and the ball must not be in a goal. A
/// moving ball must have a finite speed of at most 50 m/s. It may neither add nor remove robots.
std::optional<std::string> flawOfEdit(const MatchConfig& config, const Placement& before,
                                      const Placement& after);

/// The restart for a user's placement: play continues at once, and the team of the last restart takes it.
RestartCall editCall(const RefereeState& referee, const Placement& placement);

}  // namespace fulbito
