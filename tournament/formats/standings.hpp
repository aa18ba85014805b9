#pragma once

#include <string>
#include <vector>

#include "tournament/formats/schedule.hpp"

namespace fulbito {

/// One line of a table: a team's matches in a tournament, or in its group.
struct Standing {
  std::size_t entrant = 0;  ///< index in the plan
  int rank = 1;             ///< from 1; teams that no tie-break separates share a rank
  int group = 0;            ///< number of the group, from 0, in a round robin of several groups
  int matches = 0;
  int won = 0, drawn = 0, lost = 0;  ///< matches; a shoot-out also decides a match
  int goals_for = 0, goals_against = 0;
  int points = 0;  ///< 3 for a match won, 1 for a draw
  /// Points of pairs, 0 ... 1 each. A bye of a Swiss tournament counts as a meeting with all pairs won.
  double pair_points = 0.0;
  int byes = 0;  ///< rounds without an opponent in a Swiss tournament or knock-out
  /// The criterion that separates this line from the line above. Empty: points (Swiss: points of pairs), or
  /// the line shares the rank of the line above.
  std::string decided_by;
};

/// The table of a tournament so far, best first; several groups follow one another. It depends only on the
/// results of the first `counted` fixtures. docs/tournaments.md describes the tie-breaks of each format.
std::vector<Standing> standingsOf(const TournamentPlan& plan, const Schedule& schedule,
                                  const FixtureResults& results, std::size_t counted);

/// One tie of a knock-out: two entrants, or one with a bye.
struct KnockOutTie {
  int round = 0;
  bool third_place = false;         ///< the match between the losers of the semi-finals, in the final's round
  std::optional<std::size_t> a, b;  ///< empty: not known yet, or a bye
  std::optional<std::size_t> winner;      ///< empty: not decided yet
  std::string decided_by;                 ///< "points", "goal difference", "extra pair 1", "seeding", "bye"
  double points_a = 0.0, points_b = 0.0;  ///< points of matches so far: 1 for a win, 1/2 for a draw
  int goals_a = 0, goals_b = 0;
};
/// All ties of a knock-out by round and place in the bracket, the match for the third place last. Ties
/// 2 i and 2 i + 1 of a round lead to tie i of the next. Empty for other formats.
std::vector<KnockOutTie> bracketOf(const TournamentPlan& plan, const FixtureResults& results);

}  // namespace fulbito
