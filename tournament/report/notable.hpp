#pragma once

#include <vector>

#include "tournament/report/table.hpp"

namespace fulbito {

/// Smallest lead [Elo] of the loser that makes a match an upset, if the intervals of both do not overlap.
inline constexpr double kUpsetElo = 100.0;

/// The matches of a table that deserve a look, worst first. At most 8 walk-overs, crashes (two of each per
/// team) and abandoned matches (two). Then upsets, two per pairing, up to 14 matches in all. Then for each
/// team the match that it lost by most goals. Needs the ratings of `table`.
std::vector<NotableMatch> notableMatches(const TournamentState& state,
                                         const std::vector<std::size_t>& counted,
                                         const TournamentTable& table);

}  // namespace fulbito
