#pragma once

#include "strategies/interface/team_info.hpp"

/// The built-in teams, for the registry.
namespace fulbito {

/// Nobody moves: what a striker is tried against first.
TeamInfo idleInfo();
/// All robots drive at random, smoothly: what the referee and the engine are tried with.
TeamInfo randomTeamInfo();
/// All robots drive straight at the ball: the least that a team must beat.
TeamInfo chaserInfo();
/// The textbook team: fixed roles, and a field that leads to the ball with the right heading.
TeamInfo classicInfo();
/// The flagship: one striker, a support and a keeper who change roles as the ball asks (docs/libero.md).
TeamInfo liberoInfo();

}  // namespace fulbito
