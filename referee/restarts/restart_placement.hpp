#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "referee/state/game_event.hpp"
#include "referee/state/referee_state.hpp"

namespace fulbito {

/// The teams' wishes at a restart, world frame. A robot without a pose leaves its place to the rules.
using Proposals = PerTeam<std::optional<TeamPoses>>;

/// Where everyone stands at the restart. Robots for which `call.defaults` has no pose stay off the field. The
/// team of the call places first: where it stands does not depend on what the other proposes, so that a
/// caller may place with one proposal, show the result to the other team, and place again with both. A pose
/// that is not finite, not allowed by the rule or not free is replaced by the nearest legal free one; `log`
/// gets a `placement` event for each robot that stands a millimetre or more from where its team, or the rule,
/// wanted it. Robots that law 14 lets stay are not moved at all, even where they touch: whoever is put there
/// yields, one that is moved back further straight back. Never fails: the result is legal and nobody else
/// overlaps (a robot for which the field has no room at all is left out). The same arguments give the same
/// result.
Placement place(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                const Proposals& proposals, std::vector<GameEvent>& log);

/// What is wrong with a placement.
struct PlacementFlaw {
  TeamId team = TeamId::kBlue;
  std::uint8_t robot = 0;
  std::string_view reason;  ///< such as "overlaps a robot"; static lifetime
};

/// Whether law 14 lets that robot stay and the pose is the one that it had.
bool restsInPlace(const RestartCall& call, RobotId robot, const Pose2& pose);

/// All robots that break the rule of their restart, those of the taking team first. Of robots that overlap
/// the later one is named.
std::vector<PlacementFlaw> findPlacementFlaws(const RefereeSetup& setup, const RefereeState& state,
                                              const RestartCall& call, const Placement& placement);
/// The first of them.
std::optional<PlacementFlaw> findPlacementFlaw(const RefereeSetup& setup, const RefereeState& state,
                                               const RestartCall& call, const Placement& placement);
/// Whether there is none.
bool legalPlacement(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                    const Placement& placement);

/// The poses that the rules give to a team, world frame: what a team is shown when it is asked for wishes.
inline const TeamPoses& defaultPoses(const RestartCall& call, TeamId team) {
  return call.defaults.robots[indexOf(team)];
}

}  // namespace fulbito
