#pragma once

#include <optional>

#include "fulbito/referee.hpp"
#include "referee/state/match_view.hpp"

/// The shoot-out of law 7.2: the next kicker, the end of a kick, the end of the shoot-out.
namespace fulbito {

/// The team that takes the next kick.
TeamId nextKicker(const ShootOutRules& rules, const ShootOutState& shoot_out);

/// The team whose lead the other cannot catch any more, if any.
std::optional<TeamId> leader(const ShootOutRules& rules, const ShootOutState& shoot_out);

/// Whether no further kicks are allowed although no team leads.
bool exhausted(const ShootOutRules& rules, const ShootOutState& shoot_out);

/// How a kick ended.
enum class KickEnd { kGoal, kTime, kRest, kHeld, kLeftArea, kMidfield };

/// Processes one tick of the kick of `state.last.team`, `state.play_ticks` after its start. Returns how it
/// ended.
std::optional<KickEnd> observeKick(const RefereeSetup& setup, const RefereeState& state,
                                   const MatchView& view, ShootOutState& shoot_out);

}  // namespace fulbito
