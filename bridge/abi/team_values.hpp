#pragma once

#include <cstdint>
#include <vector>

#include "fulbito/strategy.hpp"
#include "fulbito/team.h"

/// Conversions of a team's values to the C interface (`toAbi`) and of its answers back (`fromAbi`). They
/// accept any bytes.
namespace fulbito {

/// @{ To a team.
fulbito_match_info toAbi(const MatchInfo& info);
/// `to` was made by this function or is zero: only what changes from tick to tick is written.
void toAbi(const Observation& seen, fulbito_observation& to);
fulbito_call toAbi(const GameEvent& event);
void toAbi(const PlacementRequest& request, fulbito_placement_request& to);
void toAbi(const PlayStop& stop, fulbito_stop& to);
fulbito_end toAbi(const MatchEnd& end);
fulbito_exercise toAbi(const Exercise& exercise);
/// @}

inline constexpr std::uint32_t kMostDrawings = 512;  ///< of a team per tick

/// The memory of a team's commands.
class CommandRoom {
 public:
  CommandRoom();
  /// The command before the team fills it in: all robots stand still.
  fulbito_team_command open(bool drawings_wanted);
  /// Undoes what a team must not change: where its drawings are, and how many there can be.
  void close(fulbito_team_command& command);

 private:
  std::vector<fulbito_drawing> drawings_;
  fulbito_team_command still_{};
};

/// @{ From a team. `to` keeps its memory; commands of robots from `team_size` on are not read.
void fromAbi(const fulbito_team_command& command, int team_size, TeamCommand& to);
TeamProposal fromAbi(const fulbito_placement& placement);
/// @}

}  // namespace fulbito
