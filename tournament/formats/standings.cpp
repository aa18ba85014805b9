#include "tournament/formats/standings.hpp"

#include <algorithm>

#include "tournament/formats/tables.hpp"

namespace fulbito {

std::vector<Standing> standingsOf(const TournamentPlan& plan, const Schedule& schedule,
                                  const FixtureResults& results, std::size_t counted) {
  const std::size_t known = std::min({counted, results.size(), schedule.fixtures.size()});
  const CountedResults first{plan, schedule.fixtures, ResultsView(results).first(known)};
  switch (plan.format) {
    case TournamentFormat::kMatch:
    case TournamentFormat::kRoundRobin:
      return leagueTable(first);
    case TournamentFormat::kGauntlet:
      return gauntletTable(first);
    case TournamentFormat::kKnockOut:
      return knockOutTable(first);
    case TournamentFormat::kSwiss:
      return swissTable(first);
    case TournamentFormat::kLadder:
      return ladderTable(first);
  }
  return {};
}

}  // namespace fulbito
