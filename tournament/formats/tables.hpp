#pragma once

#include <vector>

#include "tournament/formats/tally.hpp"

namespace fulbito {

/// League table of a match or round robin, group by group: points, goal difference, goals scored; then points
/// and goal difference of the matches between those who are still tied; then fewer walk-overs. When these
/// matches separate some of the tied, the others start again with the matches between themselves.
std::vector<Standing> leagueTable(const CountedResults& counted);

/// The first entrant plays more matches than the others, so that all count per match: points, goal
/// difference, goals scored, then fewer walk-overs.
std::vector<Standing> gauntletTable(const CountedResults& counted);

/// Points of pairs; Buchholz: the sum of the opponents' points of pairs; Sonneborn-Berger: the same sum, each
/// times one's own points against that opponent; goal difference; goals scored. A bye counts as an opponent
/// with as many points as oneself, from whom all pairs are won.
std::vector<Standing> swissTable(const CountedResults& counted);

/// The round reached; who is still in; the match for the third place. The others share a rank.
std::vector<Standing> knockOutTable(const CountedResults& counted);

/// The order of the ladder after the last complete round.
std::vector<Standing> ladderTable(const CountedResults& counted);

}  // namespace fulbito
