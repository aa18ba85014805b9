// Private header of referee: not installed.
#pragma once

#include <optional>

#include "referee/state/match_view.hpp"
#include "referee/state/referee_state.hpp"

/// Law 9: robots that move before the signal.
namespace fulbito {

/// A robot that moved too soon.
struct FalseStart {
  RobotId robot;
  double moved = 0.0;  ///< [m] from its place
};

/// Takes in one tick before the signal; a value when a robot has been off its place for long enough. The
/// robot that moved farthest is named; `toss` decides between equals of both teams.
std::optional<FalseStart> observeFalseStart(const RefereeSetup& setup, const MatchView& view,
                                            const RefereeState& before, Tick& away_ticks, TeamId toss);

/// What follows from a false start that `state.false_starts` already counts: the next restart. Cards and
/// robots sent off are written to `state`.
RestartCall punish(const RefereeSetup& setup, RefereeState& state, const FalseStart& fault,
                   const MatchView& view);

}  // namespace fulbito
