#pragma once

#include <string>
#include <vector>

#include "tournament/formats/schedule.hpp"

namespace fulbito {

/// One line of a table: a team's matches in a tournament, or in its group.
struct Standing {
  std::size_t entrant = 0;  ///< index in the plan
  int rank = 1;             ///< from 1; teams that no tie-break separates share a rank
  int group = 0;            ///< from 0, in a round robin of several groups
  int matches = 0;
  int won = 0, drawn = 0, lost = 0;
  int goals_for = 0, goals_against = 0;
  int points = 0;            ///< 3 for a win, 1 for a draw
  double pair_points = 0.0;  ///< points of pairs, 0 ... 1 each
  int byes = 0;              ///< rounds without an opponent
  std::string decided_by;    ///< the tie-break that separates it from the line above; empty: points
};

/// The table of a tournament so far, best first: a pure function of the first `counted` fixtures with
/// results. docs/tournaments.md documents the tie-breaks of each format.
std::vector<Standing> standingsOf(const TournamentPlan& plan, const Schedule& schedule,
                                  const FixtureResults& results, std::size_t counted);

/// One tie of a knock-out: two entrants, or one with a bye.
struct KnockOutTie {
  int round = 0;
  std::optional<std::size_t> a, b;        ///< empty: not known yet, or a bye
  std::optional<std::size_t> winner;      ///< empty: not decided yet
  std::string decided_by;                 ///< "points", "goal difference", "extra pair 1", "seeding", "bye"
  double points_a = 0.0, points_b = 0.0;  ///< of matches: 1 for a win, 1/2 for a draw
  int goals_a = 0, goals_b = 0;
};
/// The ties of a knock-out so far, by round and place in the bracket; empty for other formats.
std::vector<KnockOutTie> bracketOf(const TournamentPlan& plan, const Schedule& schedule,
                                   const FixtureResults& results);

}  // namespace fulbito
