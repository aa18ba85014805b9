#pragma once

#include "tournament/formats/schedule.hpp"

namespace fulbito {

/// Each round pairs entrants with as equal points of pairs as possible who have not met (`SwissPairing`).
/// With an odd number of entrants one has a bye per round, nobody twice; it counts as a meeting won in full.
Schedule swissSchedule(const TournamentPlan& plan, ResultsView results);

}  // namespace fulbito
