#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fulbito/referee.hpp"

namespace fulbito {

/// The teams' wishes at a restart, world frame. For a robot without a pose, the rules choose.
using Proposals = PerTeam<std::optional<TeamPoses>>;

/// The placement at the restart. Robots without a pose in `call.defaults` stay off the field.
///
/// The team of the call places first. Its places do not depend on the other team's proposals, so a caller may
/// place with one proposal, show the result to the other team, and place again with both.
///
/// The nearest legal free pose replaces a pose that is not finite, not legal or not free. `log` gets a
/// `placement` event for each robot that is a millimetre or more from the wish of its team or the rule.
/// Robots that stay by law 14 never move, even if they touch: other robots yield to them, and a robot that is
/// moved back yields straight back.
///
/// Never fails: the result is legal, and only robots that stay by law 14 may overlap. A robot for which the
/// field has no room is left out. Pure.
Placement place(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                const Proposals& proposals, std::vector<GameEvent>& log);

/// A robot whose place breaks the rule.
struct PlacementFlaw {
  TeamId team = TeamId::kBlue;
  std::uint8_t robot = 0;
  std::string_view reason;  ///< such as "overlaps a robot"; static lifetime
};

/// Whether the robot stays by law 14 and has its old pose.
bool restsInPlace(const RestartCall& call, RobotId robot, const Pose2& pose);

/// All robots that break the rule of their restart, the taking team's first. Of two overlapping robots, the
/// later one is reported.
std::vector<PlacementFlaw> findPlacementFlaws(const RefereeSetup& setup, const RefereeState& state,
                                              const RestartCall& call, const Placement& placement);
/// The first of these flaws.
std::optional<PlacementFlaw> findPlacementFlaw(const RefereeSetup& setup, const RefereeState& state,
                                               const RestartCall& call, const Placement& placement);
/// Whether there is no flaw.
bool legalPlacement(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                    const Placement& placement);

/// The rules' poses for a team, world frame. A team sees them when it is asked for its wishes.
inline const TeamPoses& defaultPoses(const RestartCall& call, TeamId team) {
  return call.defaults.robots[indexOf(team)];
}

}  // namespace fulbito
