#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tournament/statistics/davidson.hpp"

namespace fulbito {

/// Who met whom, and whether the results have most likely ratings.
struct WinGraph {
  std::vector<int> component;       ///< by entrant: groups of entrants that met, directly or not, from 0
  std::vector<bool> without_bound;  ///< by component: its likelihood has no maximum
};

/// Finds both. The likelihood of Davidson's model has a maximum if and only if
/// - the results of each component are strongly connected, where a win leads from the winner to the loser and
///   a draw both ways (otherwise a group won or lost everything against the rest), and
/// - no match was drawn, or some closed walk has more wins than draws, where draws may be walked both ways
///   (otherwise leads and draws can grow together for ever: a win and a draw without a loss, for instance).
/// The second concerns all components, which share the draw parameter.
WinGraph winGraph(std::size_t entrants, std::span<const WeightedMeeting> meetings);

}  // namespace fulbito
