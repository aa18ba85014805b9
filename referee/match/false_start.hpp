#pragma once

#include <optional>

#include "fulbito/referee.hpp"
#include "referee/state/match_view.hpp"

/// Law 9: robots that move before the signal.
namespace fulbito {

/// A robot that moved before the signal.
struct FalseStart {
  RobotId robot;
  double moved = 0.0;  ///< [m] from its place
};

/// Processes one tick before the signal. Returns the robot that moved farthest, once any robot has been off
/// its place for long enough. `toss` decides between equal robots of both teams.
std::optional<FalseStart> observeFalseStart(const RefereeSetup& setup, const MatchView& view,
                                            const RefereeState& before, Tick& away_ticks, TeamId toss);

/// The restart that follows a false start, which `state.false_starts` already counts. Writes cards and robots
/// sent off to `state`.
RestartCall punish(const RefereeSetup& setup, RefereeState& state, const FalseStart& fault,
                   const MatchView& view);

}  // namespace fulbito
