#include "navigation/guidance_strokes.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kStraight = 3e-3;  // [m] greatest distance from a line of a point that counts as on it

/// Whether all points between `first` and `last` are on the line between these two.
bool isStraight(std::span<const Vec2> path, std::size_t first, std::size_t last) {
  const Vec2 along = path[last] - path[first];
  const double length = norm(along);
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec2 rel = path[i] - path[first];
    const double off = length > kStraight ? std::abs(cross(along, rel)) / length : norm(rel);
    if (off > kStraight) return false;
  }
  return true;
}

void addPath(std::span<const Vec2> path, std::vector<GuidanceStroke>& strokes) {
  for (std::size_t first = 0; first + 1 < path.size();) {
    std::size_t last = first + 1;
    while (last + 1 < path.size() && isStraight(path, first, last + 1)) ++last;
    strokes.push_back({path[first], path[last]});
    first = last;
  }
}

void addField(const HeadingField& field, Vec2 position, Vec2 goal, std::vector<GuidanceStroke>& strokes) {
  constexpr int kArrows = 10, kSteps = 3;
  constexpr double kStep = 0.02;   // [m]
  constexpr double kHead = 0.014;  // [m] length of a side of an arrow head
  constexpr double kAngle = 2.5;   // [rad] between a side of the head and the direction of travel
  Vec2 at = position;
  for (int arrow = 0; arrow < kArrows; ++arrow) {
    double heading = field.heading(at);
    for (int step = 0; step < kSteps; ++step) {
      if (distance(at, goal) < kStep) return;
      heading = field.heading(at);
      at += math::unit(heading) * kStep;
    }
    for (const double side : {kAngle, -kAngle})
      strokes.push_back({at, at + math::unit(heading + side) * kHead});
  }
}

}  // namespace

void addStrokes(const Guidance& guidance, Vec2 position, Vec2 goal, std::vector<GuidanceStroke>& strokes) {
  if (guidance.kind == GuidanceKind::kField && guidance.field != nullptr) {
    addField(*guidance.field, position, goal, strokes);
  } else if (guidance.kind == GuidanceKind::kPath || guidance.kind == GuidanceKind::kTimedPath) {
    addPath(guidance.path, strokes);
  }
}

}  // namespace fulbito
