#include "strategies/skills/positions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fulbito {
namespace {

/// Distance [m] from `p` to the segment from `a` to `b`.
double distanceToStretch(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  const double length2 = squaredNorm(way);
  const double share = length2 > 0.0 ? std::clamp(dot(p - a, way) / length2, 0.0, 1.0) : 0.0;
  return distance(p, a + way * share);
}

}  // namespace

Vec2 keeperPoint(const FieldGeometry& field, const BallPrediction& ball, double depth, double farthest,
                 double margin) {
  const Vec2 line{-field.length / 2 + depth, 0.0};
  const auto limited = [&](Vec2 p) { return Vec2{p.x, std::clamp(p.y, -farthest, farthest)}; };
  const auto crossing = ball.crossing(line, {-1.0, 0.0});
  if (crossing && std::abs(crossing->place.y) < field.goal_width / 2 + margin)
    return limited(crossing->place);
  return limited(equalGapPoint(field, ball.positionAt(0.0), depth));
}

Vec2 shadowPoint(const FieldGeometry& field, Vec2 ball, double away) {
  const double front = -field.length / 2 + field.goal_area_depth;
  const Vec2 to_goal = ownGoal(field) - ball;
  Vec2 place = ball + unitOr(to_goal, {-1.0, 0.0}) * away;
  if (place.x >= front) return place;
  if (ball.x <= front) return {front, ball.y};
  return ball + to_goal * ((front - ball.x) / to_goal.x);
}

Vec2 reboundSpot(const FieldGeometry& field, Vec2 ball) {
  constexpr double kFromEnd = 0.35, kAside = 0.20;  // [m]
  return {field.length / 2 - kFromEnd, ball.y > 0.0 ? -kAside : kAside};
}

Vec2 clearanceTarget(const FieldGeometry& field, Vec2 ball, std::span<const Vec2> opponents) {
  // Directions by their slope off the goal line: 30, 45 and 60 degrees.
  constexpr std::array<double, 3> kUpfieldPerAside = {0.577, 1.0, 1.732};
  const double side = ball.y >= 0.0 ? 1.0 : -1.0;
  const double aside = std::max(0.05, field.width / 2 - side * ball.y);
  Vec2 best;
  double best_berth = -1.0;
  for (const double upfield : kUpfieldPerAside) {
    const Vec2 target{std::min(ball.x + aside * upfield, field.length / 2), ball.y + side * aside};
    double berth = std::numeric_limits<double>::infinity();
    for (const Vec2 opponent : opponents) {
      // An opponent behind the ball does not block it.
      if (opponent.x < ball.x - 0.05) continue;
      berth = std::min(berth, distanceToStretch(opponent, ball, target));
    }
    if (berth > best_berth) best_berth = berth, best = target;
  }
  return best;
}

}  // namespace fulbito
