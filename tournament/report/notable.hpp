#pragma once

#include <vector>

#include "tournament/report/table.hpp"

namespace fulbito {

/// Least lead [Elo] of the loser that makes a match an upset, if the intervals of both do not meet.
inline constexpr double kUpsetElo = 100.0;

/// The matches of a table that deserve a look, worst first: walk-overs, crashes (two of each
/// per team) and two abandoned matches, at most 8 in all; upsets, two per pairing and 14 with those before;
/// then the match that each team lost by most goals. Needs the ratings of `table`.
std::vector<NotableMatch> notableMatches(const TournamentState& state,
                                         const std::vector<std::size_t>& counted,
                                         const TournamentTable& table);

}  // namespace fulbito
