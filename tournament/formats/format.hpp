#pragma once

#include "tournament/formats/tally.hpp"

namespace fulbito {

/// All that one format decides. Its file defines one; `formats.cpp` lists them.
struct Format {
  /// The fixtures that follow from the results so far, as `scheduleOf`.
  Schedule (*schedule)(const TournamentPlan& plan, ResultsView results);
  /// The table of the counted results, best first, with ranks and what decided them.
  std::vector<Standing> (*table)(const CountedResults& counted);
  /// The number of fixtures at most.
  std::int64_t (*most_fixtures)(const TournamentPlan& plan);
  std::size_t most_entrants = ~std::size_t{0};
  bool has_groups = false;  ///< whether a plan may ask for groups
  /// Rounds for so many entrants unless the plan says how many; null: a plan cannot choose.
  int (*rounds)(std::size_t entrants) = nullptr;
  bool meets_once = false;          ///< nobody meets twice: fewer rounds than entrants
  bool has_test = false;            ///< whether a sequential test may end it
  bool counts_pair_points = false;  ///< whether tables rank by points of pairs, and show them
};

/// What the format of a plan decides.
const Format& formatOf(const TournamentPlan& plan);

/// `most_fixtures` where half of the entrants meet the other half in each of `roundsOf`.
std::int64_t mostOfRounds(const TournamentPlan& plan);

/// League table of a match or round robin, group by group: points, goal difference, goals scored; then points
/// and goal difference of the matches between those who are still tied; then fewer walk-overs. When these
/// matches separate some of the tied, the others start again with the matches between themselves.
std::vector<Standing> leagueTable(const CountedResults& counted);

}  // namespace fulbito
