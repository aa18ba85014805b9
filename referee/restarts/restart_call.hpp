#pragma once

#include <optional>

#include "fulbito/referee.hpp"
#include "referee/state/match_view.hpp"

/// Makes restarts from stoppages: ball spots and the rules' own placement.
namespace fulbito {

/// -1 for the team that defends the left goal, +1 for the other: the sign of x of its own goal.
inline double ownSign(const RefereeState& state, TeamId team) {
  return state.sideOf(team) == Side::kLeft ? -1.0 : 1.0;
}

/// The facts that determine a restart.
struct Stoppage {
  RestartKind kind = RestartKind::kKickOff;
  TeamId team = TeamId::kBlue;                       ///< the taking team; ignored for a free ball
  Vec2 ball;                                         ///< [m] position of the ball
  const MatchView* view = nullptr;                   ///< the robots; null at the start of a match
  std::optional<std::size_t> keeper = std::nullopt;  ///< the taking team's keeper, index in the view
};

/// The restart with its ball spot, team, delay and the places of the rules.
RestartCall makeCall(const RefereeSetup& setup, const RefereeState& state, const Stoppage& stoppage);

/// The pose of the keeper that takes a goal kick: at the table's distance from the ball, on the field and
/// facing the ball. `own_sign` is the sign of x of its goal.
Pose2 goalKickKeeper(const RefereeSetup& setup, double own_sign, Vec2 ball);

/// A kick of the shoot-out, with only kicker and keeper on the field.
RestartCall makeShootOutCall(const RefereeSetup& setup, const RefereeState& state, TeamId kicker);

/// Whether the robot takes part in the next restart: it is in the team and not sent off.
bool fielded(const RefereeSetup& setup, const RefereeState& state, TeamId team, int number);

}  // namespace fulbito
