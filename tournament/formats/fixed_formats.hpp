#pragma once

#include <vector>

#include "tournament/formats/schedule.hpp"

namespace fulbito {

/// The first entrant against each other one, all with the first start, then all with the next. With two
/// entrants: a match.
Schedule gauntletSchedule(const TournamentPlan& plan);

/// Each against each other of its group, all with the first start, then all with the next. Rounds of all
/// groups go side by side.
Schedule roundRobinSchedule(const TournamentPlan& plan);

/// The groups of a round robin, each in order of seeding. Entrants are dealt in serpentine order: to groups
/// 0, 1, 2, 2, 1, 0, 0, 1 ...
std::vector<std::vector<std::size_t>> groupsOf(const TournamentPlan& plan);

}  // namespace fulbito
