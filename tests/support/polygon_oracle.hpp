#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "navigation/methods/paths/tangent_graph_search.hpp"

namespace fulbito::test {

inline double segmentDistance(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 edge = b - a;
  const double square = squaredNorm(edge);
  const double part = square > 0.0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
  return distance(a + edge * part, p);
}

/// Length of the shortest path among discs by brute force: every disc a regular 96-gon with its corners on
/// the edge, every pair of corners that see each other joined, A* over all of them. Shares nothing with the
/// tangent graph; off by about (pi/96)^2 / 6 of the arcs. 1e18 when there is no path.
inline double polygonShortestPath(Vec2 a, Vec2 b, std::span<const Circle> circles,
                                  const FieldGeometry* bounds, double wall_margin) {
  constexpr int kCorners = 96;
  const double pi = std::acos(-1.0), shrink = std::cos(pi / kCorners);
  const auto open = [&](Vec2 p, Vec2 q) {
    return std::none_of(circles.begin(), circles.end(), [&](const Circle& c) {
      return segmentDistance(p, q, c.centre) < c.radius * shrink - 1e-9;
    });
  };
  std::vector<Vec2> nodes{a, b};
  for (const Circle& c : circles) {
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * pi * i / kCorners;
      const Vec2 p = c.centre + Vec2{std::cos(angle), std::sin(angle)} * c.radius;
      const bool inside = bounds == nullptr || wallClearance(*bounds, p) >= wall_margin;
      if (inside && open(p, p)) nodes.push_back(p);
    }
  }
  std::vector<double> cost(nodes.size(), 1e18);
  std::vector<char> done(nodes.size(), 0);
  cost[0] = 0.0;
  for (;;) {
    std::size_t best = nodes.size();
    double least = 1e17;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double estimate = cost[i] + distance(nodes[i], b);
      if (!done[i] && estimate < least) least = estimate, best = i;
    }
    if (best == nodes.size()) return 1e18;
    if (best == 1) return cost[1];
    done[best] = 1;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double reached = cost[best] + distance(nodes[best], nodes[i]);
      if (!done[i] && reached < cost[i] && open(nodes[best], nodes[i])) cost[i] = reached;
    }
  }
}

}  // namespace fulbito::test
