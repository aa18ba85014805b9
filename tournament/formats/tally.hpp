#pragma once

#include <vector>

#include "tournament/formats/ranking.hpp"

namespace fulbito {

/// The results that a table counts: the schedule's fixtures, and results of the first of them.
struct CountedResults {
  const TournamentPlan& plan;
  const std::vector<Fixture>& fixtures;
  ResultsView results;
};

/// Points of a match in a league for a share of 1, 1/2 or 0: 3, 1 or 0.
constexpr int leaguePoints(double share) { return share == 1.0 ? 3 : share == 0.5 ? 1 : 0; }

/// Calls `use(fixture, pair)` for each counted result.
template <typename Use>
void forEachResult(const CountedResults& counted, Use use) {
  for (std::size_t i = 0; i < counted.results.size(); ++i) {
    if (counted.results[i]) use(counted.fixtures[i], *counted.results[i]);
  }
}

/// One line per entrant, by number, with matches, goals and points; without ranks.
std::vector<Standing> tally(const CountedResults& counted);

/// The walk-overs that each entrant lost, as a criterion: fewer are better.
Criterion fewerForfeits(const CountedResults& counted);

constexpr int goalDifferenceOf(const Standing& line) { return line.goals_for - line.goals_against; }
constexpr int goalsForOf(const Standing& line) { return line.goals_for; }

/// A value of each line as a criterion.
template <typename Value>
Criterion criterion(std::string_view name, const std::vector<Standing>& lines, Value value) {
  Criterion result{name, std::vector<double>(lines.size())};
  for (const Standing& line : lines) result.values[line.entrant] = static_cast<double>(value(line));
  return result;
}

}  // namespace fulbito
