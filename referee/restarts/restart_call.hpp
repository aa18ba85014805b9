// Private header of referee: not installed.
#pragma once

#include <optional>

#include "referee/state/match_view.hpp"
#include "referee/state/referee_state.hpp"

/// From a stoppage to the rules' own placement: ball spots and default tables.
namespace fulbito {

/// -1 for the team that defends the left goal, +1 for the other: the sign of x of its own goal.
inline double ownSign(const RefereeState& state, TeamId team) {
  return state.sideOf(team) == Side::kLeft ? -1.0 : 1.0;
}

/// What decides where a restart is.
struct Stoppage {
  RestartKind kind = RestartKind::kKickOff;
  TeamId team = TeamId::kBlue;      ///< who takes it; ignored of a free ball
  Vec2 ball;                        ///< [m] where the ball was
  const MatchView* view = nullptr;  ///< where the robots were; null at the beginning of a match
  std::optional<std::size_t> keeper = std::nullopt;  ///< the taking team's, by its place in the view
};

/// The restart with its ball spot, the team of a free ball, the delay, and the places of the rules.
RestartCall makeCall(const RefereeSetup& setup, const RefereeState& state, const Stoppage& stoppage);

/// Where the rules put the keeper that takes a goal kick: by the table beside the table's ball, and as far
/// from any other, on the field and facing it. `own_sign`: of x of its goal.
Pose2 goalKickKeeper(const RefereeSetup& setup, double own_sign, Vec2 ball);

/// A penalty of the shoot-out: kicker and keeper alone on the field.
RestartCall makeShootOutCall(const RefereeSetup& setup, const RefereeState& state, TeamId kicker);

/// Whether the robot takes part at the next restart: it is in the team and not sent off.
bool fielded(const RefereeSetup& setup, const RefereeState& state, TeamId team, int number);

}  // namespace fulbito
