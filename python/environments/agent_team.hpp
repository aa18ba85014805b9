#pragma once

#include <array>
#include <memory>
#include <optional>

#include "fulbito/strategy.hpp"

namespace fulbito {

/// What a caller and the robots that it drives share. It outlives the match.
struct AgentSlot {
  std::array<bool, kMaxTeamSize> drives{};  ///< by robot number: the caller drives this robot
  MatchInfo info;                           ///< of the match, once it is created
  Observation seen;                         ///< the team's last observation, in its own frame
  std::array<RobotCommand, kMaxTeamSize> commands =
      {};       ///< of the robots that the caller drives, in that frame
  Vec2 answer;  ///< [m] in that frame: the reply to a task that asks for a prediction
};

/// A team whose robots the caller drives through the slot; the others play as `mates` decide. In phase
/// `MatchPhase::kDeciding` the slot has the observation of the tick, and the caller sets the commands. The
/// team stands where the mates wish. `GoTo::navigator` of the caller's commands is replaced: it is
/// `navigator`.
/// @param mates      empty: robots that the caller does not drive stand still
/// @param navigator  plans the ways of the caller's commands of kind kGoTo
TeamChoice agentTeam(std::string name, std::shared_ptr<AgentSlot> slot, std::optional<TeamChoice> mates,
                     NavigatorChoice navigator);

}  // namespace fulbito
