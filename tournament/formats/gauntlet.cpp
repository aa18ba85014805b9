#include <algorithm>
#include <array>

#include "tournament/formats/format.hpp"

namespace fulbito {
namespace {

/// The first entrant against each other one: all with the first start, then all with the second, and so on.
/// With two entrants this is a match.
Schedule gauntletSchedule(const TournamentPlan& plan, ResultsView /*results*/) {
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

std::int64_t mostMeetings(const TournamentPlan& plan) {
  return (static_cast<std::int64_t>(plan.entrants.size()) - 1) * plan.pairs;
}

/// Ranks per match, because the first entrant plays more matches than the others: points, goal difference,
/// goals scored; then by fewer walk-overs.
std::vector<Standing> gauntletTable(const CountedResults& counted) {
  const std::vector<Standing> table = tally(counted);
  // Division rounds correctly, so equal ratios of whole numbers give equal doubles.
  const auto per_match = [&](std::string_view name, auto value) {
    return criterion(name, table, [&](const Standing& line) {
      return static_cast<double>(value(line)) / std::max(1, line.matches);
    });
  };
  const std::array criteria{per_match("points", [](const Standing& line) { return line.points; }),
                            per_match("goal difference per match", goalDifferenceOf),
                            per_match("goals scored per match", goalsForOf), fewerForfeits(counted)};
  return ranked(table, criteria, "points");
}

}  // namespace

extern const Format kGauntletFormat{
    .schedule = gauntletSchedule, .table = gauntletTable, .most_fixtures = mostMeetings};
/// A match is a gauntlet of two entrants, but with the table of a league.
extern const Format kMatchFormat{.schedule = gauntletSchedule,
                                 .table = leagueTable,
                                 .most_fixtures = mostMeetings,
                                 .most_entrants = 2,
                                 .has_test = true};

}  // namespace fulbito
