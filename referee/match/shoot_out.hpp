// Private header of referee: not installed.
#pragma once

#include <optional>

#include "referee/state/match_view.hpp"
#include "referee/state/referee_state.hpp"

/// The shoot-out of law 7.2: who kicks next, when a kick is over, when all is decided.
namespace fulbito {

/// The team that takes the next kick.
TeamId nextKicker(const ShootOutRules& rules, const ShootOutState& shoot_out);

/// The team that can no longer be caught, once there is one.
std::optional<TeamId> leader(const ShootOutRules& rules, const ShootOutState& shoot_out);

/// Whether no further kicks are allowed, though nobody leads.
bool exhausted(const ShootOutRules& rules, const ShootOutState& shoot_out);

/// How a kick ended.
enum class KickEnd { kGoal, kTime, kRest, kHeld, kLeftArea, kMidfield };

/// Takes in one tick of the kick of `state.last.team`, `state.play_ticks` into it; a value when it is over.
std::optional<KickEnd> observeKick(const RefereeSetup& setup, const RefereeState& state,
                                   const MatchView& view, ShootOutState& shoot_out);

}  // namespace fulbito
