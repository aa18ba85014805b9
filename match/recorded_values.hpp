// Private header of match: not installed.
#pragma once

#include "referee/game_event.hpp"
#include "replays/recording.hpp"
#include "strategies/team_command.hpp"

namespace fulbito {

/// @{ What happens in a match as a recording keeps it. The target's memory is used again.
void describe(const GameEvent& event, RecordedEvent& recorded);
/// `side` is the team's.
void describe(const DebugDrawing& drawing, Tick tick, TeamId team, Side side, RecordedDrawing& recorded);
/// @}

}  // namespace fulbito
