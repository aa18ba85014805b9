#include "strategies/teams/libero/attack/aim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/core/models/field_places.hpp"

namespace fulbito::libero {
namespace {

constexpr double kIntoWall = 0.15;  // [rad] into the wall: cages the ball while it is pushed along

/// Along which way a wall is followed: up the side walls, toward their goal and away from ours.
Vec2 wayAlong(Vec2 normal, Vec2 ball) {
  Vec2 along = perp(normal);
  const Vec2 wanted{1.0, ball.x > 0.0 ? -std::copysign(1.0, ball.y) : std::copysign(1.0, ball.y)};
  return dot(along, wanted) < 0.0 ? -along : along;
}

/// Where on their goal line, within `edge` [m] of its middle, a ball that already rolls toward it would come
/// nearest to going in by itself; empty where it rolls otherwise, or far past. It keeps most of what it has
/// across: the blow that takes that away turns the robot so far from the ball's way that it slides past and
/// comes again.
std::optional<double> rollsAt(const Picture& picture, Vec2 from, double edge) {
  constexpr double kRolls = 0.25;   // [m/s] a slower ball goes where it is pushed
  constexpr double kToward = 0.1;   // [m/s] up the field, at least
  constexpr double kInside = 0.02;  // [m] off the edge: the blow is not exact
  const Vec2 velocity = picture.ball.now().velocity;
  if (velocity.x < kToward || squaredNorm(velocity) < kRolls * kRolls) return std::nullopt;
  const double most = edge - kInside;
  const double y = from.y + (picture.pitch.half_length - from.x) * velocity.y / velocity.x;
  if (std::abs(y) > 2.0 * picture.pitch.goal_half) return std::nullopt;
  return std::clamp(y, -most, most);
}

}  // namespace

double openMouth(const Picture& picture, Vec2 from, double shooter_y, double last) {
  const Pitch& pitch = picture.pitch;
  const double edge = pitch.goal_half - pitch.ball_radius - 0.015;
  const double line = pitch.half_length;
  // Of two that are alike the one across from the shooter: at a kick-off it stands askew already.
  const double first = shooter_y >= from.y ? -1.0 : 1.0;
  constexpr double kTurned = 0.3;  // [m] of gap that a metre off the ball's own way is worth
  const std::optional<double> rolls_at = rollsAt(picture, from, edge);
  double best = 0.0, best_score = -1e9;
  for (int i = 0; i < (rolls_at ? 8 : 7); ++i) {
    const double y = i == 7 ? *rolls_at : first * edge * (3 - i) / 3.0;
    const Vec2 way = Vec2{line, y} - from;
    const double length = norm(way);
    const Vec2 to = way / std::max(length, 1e-6);
    double score = 0.10;  // wider than this is no better
    for (int j = 0; j < picture.seen.team_size; ++j) {
      if (!picture.opponentPresent(j)) continue;
      const Vec2 rel = intoFrame(to, picture.opponent(j).pose.position - from);
      if (rel.x < 0.0 || rel.x > length + 0.05) continue;
      score = std::min(score, std::abs(rel.y) - 0.06);
    }
    score -= 0.06 * std::abs(y);
    if (rolls_at) score -= kTurned * std::abs(y - *rolls_at);
    if (std::abs(y - last) < 0.02) score += 0.02;
    if (score > best_score) best_score = score, best = y;
  }
  return best;
}

Aim aimAt(const Pitch& pitch, Vec2 ball, Vec2 target) {
  Aim aim{ball, unitOr(target - ball, {1.0, 0.0}), false};
  const double room = pitch.ball_radius + 0.03;
  // In front of a goal's mouth there is no wall.
  if (std::abs(ball.y) <= pitch.goal_half || wallClearance(pitch.field, ball) > room) return aim;
  const Vec2 normal = nearestWallNormal(pitch.field, ball);
  if (dot(aim.direction, normal) < -0.1) return aim;
  const Vec2 along = wayAlong(normal, ball);
  aim.direction = unitOr(along - normal * kIntoWall, along);
  aim.contact = insideWalls(pitch.field, ball, pitch.robot_half + 0.003);
  aim.wall = true;
  return aim;
}

}  // namespace fulbito::libero
