#pragma once

#include <array>
#include <span>
#include <vector>

#include "navigation/geometry/circle.hpp"

namespace fulbito {

inline constexpr std::size_t kBezierDegree = 10;  ///< highest degree that can be sampled
inline constexpr std::size_t kBezierPoints = 97;  ///< points of a sampled curve, at equal parameter steps
using BezierSamples = std::array<Vec2, kBezierPoints>;

/// Points of the Bezier curve with 2 ... kBezierDegree + 1 control points, at parameters 0, 1/96 ... 1.
void sampleBezier(std::span<const Vec2> control, BezierSamples& out);

/// Only the sample with the index `index`.
Vec2 bezierPoint(std::span<const Vec2> control, std::size_t index);

/// Unit vector across the line from `robot` to an obstacle, to the left: (-sin phi, cos phi) with phi =
/// atan2(O - H). Jung & Lee (2015) print theta = pi - phi in (1), with which the segment AB would not be
/// across the line (docs/papers.md). If the points coincide, the line is taken along +x.
Vec2 acrossLine(Vec2 robot, Vec2 obstacle);

/// The ends A (left) and B (right) of an obstacle's safe region, Jung & Lee (2015), (2)-(5), A = 3 r + alpha.
/// Here r is the obstacle's radius, not the distance printed in (5) (docs/papers.md).
struct SafeEnds {
  Vec2 a;
  Vec2 b;
};
SafeEnds safeEnds(Vec2 robot, const Circle& obstacle, double alpha);

/// Control point that leads the curve past an obstacle, Jung & Lee (2015), (6)-(8), with the corrected phi =
/// atan2(end - O) (docs/papers.md). It is `tbp` [m] from the obstacle, toward the end on that side.
/// @param side  +1: past A (on the left of the obstacle as seen from the robot), -1: past B
Vec2 controlPoint(Vec2 robot, Vec2 obstacle, int side, double tbp);

/// Whether the segments p-q and a-b cross at a point inside both.
bool properlyIntersect(Vec2 p, Vec2 q, Vec2 a, Vec2 b);

/// Indices of the obstacles whose segment AB crosses the line from `robot` to `goal` (Jung & Lee, Figs
/// 18-20), in their order along the line.
void selectObstacles(Vec2 robot, Vec2 goal, std::span<const Circle> obstacles, double alpha,
                     std::vector<std::size_t>& out);

/// Sorts indices of obstacles by their place along the line from `robot` to `goal`.
void sortAlongLine(Vec2 robot, Vec2 goal, std::span<const Circle> obstacles,
                   std::vector<std::size_t>& indices);

}  // namespace fulbito
