#include "tournament/formats/fixed_formats.hpp"

namespace fulbito {

Schedule gauntletSchedule(const TournamentPlan& plan) {
  Schedule schedule;
  schedule.complete = true;
  schedule.fixtures.reserve(static_cast<std::size_t>(mostFixtures(plan)));
  for (int cycle = 0; cycle < plan.pairs; ++cycle) {
    for (std::size_t opponent = 1; opponent < plan.entrants.size(); ++opponent) {
      schedule.fixtures.push_back({0, opponent, cycle, static_cast<std::size_t>(cycle)});
    }
  }
  return schedule;
}

}  // namespace fulbito
