#pragma once

#include "tournament/formats/tally.hpp"

namespace fulbito {

/// Everything that is specific to one format. Each format's file defines one of these; `formats.cpp` lists
/// them.
struct Format {
  /// The fixtures that follow from the results so far, as `scheduleOf`.
  Schedule (*schedule)(const TournamentPlan& plan, ResultsView results);
  /// The table of the counted results, best first, with ranks and what decided them.
  std::vector<Standing> (*table)(const CountedResults& counted);
  /// The largest number of fixtures that the plan can lead to.
  std::int64_t (*most_fixtures)(const TournamentPlan& plan);
  std::size_t most_entrants = ~std::size_t{0};
  bool has_groups = false;  ///< whether a plan may ask for groups
  /// Default number of rounds for a number of entrants. Null: plans of this format cannot choose rounds.
  int (*rounds)(std::size_t entrants) = nullptr;
  bool meets_once = false;          ///< nobody meets twice, so a plan has fewer rounds than entrants
  bool has_test = false;            ///< whether a sequential test may end the tournament
  bool counts_pair_points = false;  ///< whether the table ranks by points of pairs, and reports show them
};

/// The format of a plan.
const Format& formatOf(const TournamentPlan& plan);

/// `most_fixtures` of a format in which half of the entrants meet the other half in each round.
std::int64_t mostOfRounds(const TournamentPlan& plan);

/// League table of a match or round robin, group by group. Criteria: points, goal difference, goals scored;
/// then points and goal difference in the matches between entrants still tied; then fewer walk-overs. If
/// these matches separate only some of the tied, the others are compared again by the matches between
/// themselves.
std::vector<Standing> leagueTable(const CountedResults& counted);

}  // namespace fulbito
