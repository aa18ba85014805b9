#include "tournament/statistics/win_graph.hpp"

#include <algorithm>

namespace fulbito {
namespace {

using Edges = std::vector<std::vector<std::size_t>>;  // by entrant: entrants that its edges lead to

/// Edges from winner to loser, and both ways for draws. `reverse` turns all of them round.
Edges edgesOf(std::size_t entrants, std::span<const WeightedMeeting> meetings, bool reverse) {
  Edges edges(entrants);
  for (const WeightedMeeting& m : meetings) {
    const double forth = reverse ? m.losses : m.wins, back = reverse ? m.wins : m.losses;
    if (forth + m.draws > 0.0) edges[m.a].push_back(m.b);
    if (back + m.draws > 0.0) edges[m.b].push_back(m.a);
  }
  return edges;
}

/// Sets the mark of `first` and of all unmarked (-1) entrants that can be reached from it.
void spread(const Edges& edges, std::size_t first, int mark, std::vector<int>& marks) {
  std::vector<std::size_t> open{first};
  marks[first] = mark;
  while (!open.empty()) {
    const std::size_t from = open.back();
    open.pop_back();
    for (const std::size_t to : edges[from]) {
      if (marks[to] >= 0) continue;
      marks[to] = mark;
      open.push_back(to);
    }
  }
}

/// Spreads a new mark from each entrant without one, in order.
std::vector<int> spreadAll(const Edges& edges) {
  std::vector<int> marks(edges.size(), -1);
  int next = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (marks[i] < 0) spread(edges, i, next++, marks);
  }
  return marks;
}

std::vector<int> componentsOf(std::size_t entrants, std::span<const WeightedMeeting> meetings) {
  Edges both = edgesOf(entrants, meetings, false);
  const Edges reversed = edgesOf(entrants, meetings, true);
  for (std::size_t i = 0; i < entrants; ++i)
    both[i].insert(both[i].end(), reversed[i].begin(), reversed[i].end());
  return spreadAll(both);
}

/// Marks components in which the first entrant does not reach all others.
void markUnreached(const Edges& edges, const std::vector<int>& component, std::vector<bool>& unreached) {
  std::vector<int> marks(edges.size(), -1);
  std::vector<bool> begun(unreached.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto group = static_cast<std::size_t>(component[i]);
    if (!begun[group]) spread(edges, i, 0, marks);
    begun[group] = true;
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (marks[i] < 0) unreached[static_cast<std::size_t>(component[i])] = true;
  }
}

bool raise(double& value, double least) {
  if (value >= least) return false;
  value = least;
  return true;
}

/// Bellman-Ford: raises leads until each winner is 1 above the loser and drawn entrants are at most 1 apart.
/// This never ends if and only if some closed walk has more wins than draws.
bool winsOutnumberDraws(std::size_t entrants, std::span<const WeightedMeeting> meetings) {
  std::vector<double> lead(entrants, 0.0);
  bool raised = true;
  for (std::size_t round = 0; raised && round <= entrants; ++round) {
    raised = false;
    for (const WeightedMeeting& m : meetings) {
      if (m.wins > 0.0 && m.losses > 0.0) return true;
      const double a_over_b = m.wins > 0.0 ? 1.0 : -1.0, b_over_a = m.losses > 0.0 ? 1.0 : -1.0;
      if (m.wins + m.draws > 0.0) raised |= raise(lead[m.a], lead[m.b] + a_over_b);
      if (m.losses + m.draws > 0.0) raised |= raise(lead[m.b], lead[m.a] + b_over_a);
    }
  }
  return raised;
}

}  // namespace

WinGraph winGraph(std::size_t entrants, std::span<const WeightedMeeting> meetings) {
  WinGraph graph;
  graph.component = componentsOf(entrants, meetings);
  const int groups = entrants > 0 ? 1 + *std::max_element(graph.component.begin(), graph.component.end()) : 0;
  graph.without_bound.assign(static_cast<std::size_t>(groups), false);
  markUnreached(edgesOf(entrants, meetings, false), graph.component, graph.without_bound);
  markUnreached(edgesOf(entrants, meetings, true), graph.component, graph.without_bound);
  const bool drawn =
      std::any_of(meetings.begin(), meetings.end(), [](const WeightedMeeting& m) { return m.draws > 0.0; });
  const bool any =
      std::find(graph.without_bound.begin(), graph.without_bound.end(), true) != graph.without_bound.end();
  if (drawn && !any && !winsOutnumberDraws(entrants, meetings))
    std::fill(graph.without_bound.begin(), graph.without_bound.end(), true);
  return graph;
}

}  // namespace fulbito
