#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tournament/statistics/davidson.hpp"

namespace fulbito {

/// The components of the graph of meetings, and whether their ratings have a maximum of the likelihood.
struct WinGraph {
  /// By entrant: number, from 0, of the group of entrants that met directly or indirectly.
  std::vector<int> component;
  std::vector<bool> without_bound;  ///< by component: the likelihood has no maximum
};

/// Finds components and whether their likelihood is bounded. The likelihood of Davidson's model has a maximum
/// if and only if
/// - each component is strongly connected, with an edge from winner to loser for a win, and both ways for a
///   draw (otherwise a group won or lost everything against the rest), and
/// - no match was drawn, or some closed walk has more wins than draws, where draws may be walked both ways
///   (otherwise leads and draws can grow together without limit: a win and a draw without a loss, for
///   instance).
/// The second condition is about all components together, because they share the draw parameter.
WinGraph winGraph(std::size_t entrants, std::span<const WeightedMeeting> meetings);

}  // namespace fulbito
