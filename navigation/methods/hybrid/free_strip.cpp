#include "navigation/methods/hybrid/free_strip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

// Lengths at a body of 7.5 cm.
constexpr double kReach = 0.10;    // [m] from the middle, to what counts
constexpr double kBeside = 0.075;  // [m] along the strip: what its width is measured by
constexpr double kFar = 0.2;       // [m] from the middle, beyond which nothing bounds a strip
constexpr double kEdge = 0.012;    // [m] beyond the strip's edge: bodies that reach so near begin and end it
constexpr int kTurns = 12;         // directions tried to either side
constexpr double kTurn = 0.05;     // [rad] between them

/// How far the nearest of `cells` is to the left (`side` 1) or right (-1) of the axis.
double roomBeside(const std::vector<Vec2>& cells, Vec2 axis, double side, double size) {
  double room = 1.0;
  for (const Vec2 cell : cells) {
    if (std::abs(dot(axis, cell)) < kBeside * size) room = std::min(room, side * cross(axis, cell));
  }
  return room;
}

}  // namespace

std::optional<FreeStrip> StripFinder::find(const ProvenMap& map, Vec2 middle, Vec2 way, double size) {
  left_.clear(), right_.clear();
  const double reach = kReach * size;
  map.forOccupied(middle, reach, [&](int x, int y, const ProvenMap::Cell&) {
    const Vec2 cell = map.middle(x, y) - middle;
    if (squaredNorm(cell) <= reach * reach) (cross(way, cell) > 0.0 ? left_ : right_).push_back(cell);
  });
  if (left_.empty() || right_.empty()) return {};
  std::optional<FreeStrip> best;
  for (int i = -kTurns; i <= kTurns; ++i) {
    const Vec2 axis = outOfFrame(way, math::unit(i * kTurn));
    const double left = roomBeside(left_, axis, 1.0, size), right = roomBeside(right_, axis, -1.0, size);
    if (std::max(left, right) >= kFar * size || (best && left + right <= best->width)) continue;
    best = FreeStrip{middle + perp(axis) * ((left - right) / 2), axis, left + right};
  }
  if (!best) return {};
  for (const auto* side : {&left_, &right_}) {
    for (const Vec2 cell : *side) {
      const Vec2 p = intoFrame(best->axis, cell + middle - best->middle);
      if (std::abs(p.y) >= best->width / 2 + kEdge * size) continue;
      best->entry = std::min(best->entry, p.x), best->exit = std::max(best->exit, p.x);
    }
  }
  return best;
}

void StripFinder::prolong(const ProvenMap& map, Vec2 place, double reach, double size, FreeStrip& strip) {
  const double at = strip.along(place);
  map.forOccupied(place, reach + strip.width, [&](int x, int y, const ProvenMap::Cell&) {
    const Vec2 cell = map.middle(x, y);
    const double along = strip.along(cell);
    if (std::abs(strip.aside(cell)) < strip.width / 2 + kEdge * size && std::abs(along - at) < reach)
      strip.exit = std::max(strip.exit, along);
  });
}

}  // namespace fulbito
