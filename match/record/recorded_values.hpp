#pragma once

#include "fulbito/match.hpp"
#include "fulbito/recording.hpp"
#include "fulbito/referee.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// @{ Converts values of a match to recorded ones. Reuses the target's memory.
void describe(const GameEvent& event, RecordedEvent& recorded);
/// `side` is the team's side.
void describe(const DebugDrawing& drawing, Tick tick, TeamId team, Side side, RecordedDrawing& recorded);
/// @}

/// Calls `each(drawing, team)` for all drawings of the teams and their navigators in one tick.
template <typename Each>
void forEachDrawing(const MatchTick& tick, const Each& each) {
  for (const TeamId team : kTeams) {
    if (const TeamCommand* decision = tick.decisions[indexOf(team)]) {
      for (const DebugDrawing& drawing : decision->drawings) each(drawing, team);
    }
    for (const DebugDrawing& drawing : tick.navigator_drawings[indexOf(team)]) each(drawing, team);
  }
}

}  // namespace fulbito
