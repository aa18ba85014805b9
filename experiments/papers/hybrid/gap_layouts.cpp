#include "experiments/papers/hybrid/gap_layouts.hpp"

#include <cmath>
#include <string>

#include "experiments/papers/random/streams.hpp"
#include "fulbito/experiment.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::hybrid {
namespace {

constexpr double kRobot = 0.075;                         // [m] width
constexpr double kSlit = 0.4 * kRobot;                   // [m]
constexpr double kHalfLength = 0.75, kHalfWidth = 0.65;  // [m] of the field
constexpr double kLong = 0.75;       // [m] length of a wall before it is cut at the field's
constexpr double kOutOfLine = 0.02;  // [m]
constexpr double kMostTilt = 0.35;   // [rad]
constexpr double kMostTurn = 0.5;    // [rad] start headings beside the goal

bool isWall(const ObstacleSpec& body) { return body.shape == ObstacleShape::kBox && body.width == kLong; }

ObstacleSpec drawBody(Rng& rng, GapKind kind, bool at_gap) {
  if (kind == GapKind::kMixed) {
    const auto pick = rng.below(at_gap ? 3 : 2);
    kind = pick == 0 ? GapKind::kDiscs : pick == 1 ? GapKind::kBoxes : GapKind::kDoorway;
  }
  ObstacleSpec body;
  body.shape = kind == GapKind::kDiscs ? ObstacleShape::kDisc : ObstacleShape::kBox;
  if (kind == GapKind::kDiscs) {
    body.radius = rng.uniform(0.015, 0.10);
  } else if (kind == GapKind::kBoxes) {
    body.length = body.width = rng.uniform(0.03, 0.15);
    body.pose.heading = rng.uniform(-math::kPi, math::kPi);
  } else {
    body.length = rng.uniform(0.01, 0.08), body.width = kLong;
  }
  body.pose.position.x = rng.uniform(-kOutOfLine, kOutOfLine);
  return body;
}

/// Half of a body's extent along the barrier.
double halfAcross(const ObstacleSpec& body) {
  if (body.shape == ObstacleShape::kDisc) return body.radius;
  const math::SinCos sc = math::sinCos(body.pose.heading);
  return 0.5 * (body.length * std::abs(sc.sin) + body.width * std::abs(sc.cos));
}

/// Puts `body` beside `fixed`, above it with `side` 1, so that `gap` [m] are between them.
void putBeside(ObstacleSpec& body, const ObstacleSpec& fixed, double side, double gap) {
  double low = 0.0, high = 3.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    body.pose.position.y = fixed.pose.position.y + side * middle;
    (distanceBetween(body, fixed) < gap ? low : high) = middle;
  }
  body.pose.position.y = fixed.pose.position.y + side * high;
}

/// The barrier along y, its gap about the origin.
std::vector<ObstacleSpec> drawBarrier(Rng& rng, GapKind kind, double gap) {
  ObstacleSpec right = drawBody(rng, kind, true), left = drawBody(rng, kind, true);
  putBeside(left, right, 1.0, gap);
  const double middle =
      (right.pose.position.y + halfAcross(right) + left.pose.position.y - halfAcross(left)) / 2;
  left.pose.position.y -= middle, right.pose.position.y -= middle;
  std::vector<ObstacleSpec> bodies{left, right};
  for (const double side : {1.0, -1.0}) {
    ObstacleSpec last = side > 0.0 ? left : right;
    while (!isWall(last) && std::abs(last.pose.position.y) < 0.9) {
      ObstacleSpec next = drawBody(rng, kind, false);
      putBeside(next, last, side, kSlit);
      bodies.push_back(next);
      last = next;
    }
  }
  return bodies;
}

/// Cuts a wall where the field ends, and pulls other bodies that reach over its edge onto it.
bool fitIn(ObstacleSpec& body, Vec2 across, double side) {
  if (isWall(body)) {
    const Vec2 inner = body.pose.position - across * (side * body.width / 2);
    body.width = (kHalfWidth - side * inner.y) / across.y;
    body.pose.position = inner + across * (side * body.width / 2);
    return body.width >= 0.02;
  }
  const double outside = std::abs(body.pose.position.y) - kHalfWidth;
  if (outside > 0.1) return false;
  if (outside >= 0.0) body.pose.position = body.pose.position - across * (side * (outside + 1e-6) / across.y);
  return std::abs(body.pose.position.x) < kHalfLength;
}

bool isFree(const Layout& layout, Vec2 place, double room) {
  if (std::abs(place.x) > kHalfLength - 0.08 || std::abs(place.y) > kHalfWidth - 0.08) return false;
  ObstacleSpec point;
  point.radius = 0.001, point.pose.position = place;
  for (const ObstacleSpec& body : layout.obstacles) {
    if (distanceBetween(body, point) < room) return false;
  }
  return true;
}

/// Draws start and goal; false where no pair is found.
bool drawTask(Rng& rng, Vec2 origin, Vec2 axis, Layout& layout) {
  for (int i = 0; i < 50; ++i) {
    const double from_x = -rng.uniform(0.30, 0.55), from_y = rng.uniform(-0.25, 0.25);
    const double to_x = rng.uniform(0.25, 0.50), to_y = rng.uniform(-0.25, 0.25);
    const double turn = rng.uniform(-kMostTurn, kMostTurn);
    // The straight line misses the gap by 20 cm at most.
    if (std::abs(from_y - from_x * (to_y - from_y) / (to_x - from_x)) > 0.20) continue;
    layout.start.position = origin + outOfFrame(axis, {from_x, from_y});
    layout.goal = origin + outOfFrame(axis, {to_x, to_y});
    layout.start.heading = math::wrapAngle(math::angleOf(layout.goal - layout.start.position) + turn);
    if (isFree(layout, layout.start.position, 0.10) && isFree(layout, layout.goal, 0.07)) return true;
  }
  return false;
}

}  // namespace

std::string_view nameOf(GapKind kind) {
  switch (kind) {
    case GapKind::kDiscs:
      return "discs";
    case GapKind::kBoxes:
      return "boxes";
    case GapKind::kDoorway:
      return "doorway";
    default:
      return "mixed";
  }
}

Layout gapOfKind(GapKind kind, std::uint64_t seed, std::uint64_t index, double widths) {
  Rng rng(seed, kLayoutStream, index + ((std::uint64_t{14} + static_cast<std::uint64_t>(kind)) << 32));
  Layout layout;
  layout.name = std::string(nameOf(kind)) + "-" + std::to_string(index);
  layout.field = "jung-lee-2015";
  for (;;) {
    layout.obstacles.clear();
    const std::vector<ObstacleSpec> barrier = drawBarrier(rng, kind, widths * kRobot);
    const double tilt = rng.uniform(-kMostTilt, kMostTilt), x = rng.uniform(-0.10, 0.10);
    const Vec2 origin{x, rng.uniform(-0.25, 0.25)}, axis = math::unit(tilt);
    for (ObstacleSpec body : barrier) {
      const double side = body.pose.position.y > 0.0 ? 1.0 : -1.0;
      body.pose.position = origin + outOfFrame(axis, body.pose.position);
      body.pose.heading = math::wrapAngle(body.pose.heading + tilt);
      if (fitIn(body, perp(axis), side)) layout.obstacles.push_back(body);
    }
    if (drawTask(rng, origin, axis, layout)) return layout;
  }
}

}  // namespace fulbito::hybrid
