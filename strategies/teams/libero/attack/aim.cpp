#include "strategies/teams/libero/attack/aim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/core/models/field_places.hpp"

namespace fulbito::libero {
namespace {

/// Direction along a wall: upfield at side walls, toward the opponents' goal at their end, away from the own
/// goal at the own end.
Vec2 wayAlong(Vec2 normal, Vec2 ball) {
  Vec2 along = perp(normal);
  const Vec2 wanted{1.0, ball.x > 0.0 ? -std::copysign(1.0, ball.y) : std::copysign(1.0, ball.y)};
  return dot(along, wanted) < 0.0 ? -along : along;
}

/// The y on the opponents' goal line, within `edge` [m] of the goal's middle, nearest to where a ball that
/// already rolls there would arrive. Empty if the ball rolls elsewhere or far past the goal. A target far
/// from it would need a strike that turns the robot away from the ball's direction, so that it slides past
/// the ball.
std::optional<double> rollsAt(const Picture& picture, Vec2 from, double edge) {
  const double rolls = picture.tuning.rolls;
  const Vec2 velocity = picture.ball.now().velocity;
  if (velocity.x < rolls / 2 || squaredNorm(velocity) < rolls * rolls) return std::nullopt;
  const double most = edge - picture.tuning.clearance;
  const double y = from.y + (picture.pitch.half_length - from.x) * velocity.y / velocity.x;
  if (std::abs(y) > 2.0 * picture.pitch.goal_half) return std::nullopt;
  return std::clamp(y, -most, most);
}

}  // namespace

double openMouth(const Picture& picture, Vec2 from, double shooter_y, double last) {
  const Pitch& pitch = picture.pitch;
  const double edge = pitch.goal_half - pitch.ball_radius - picture.tuning.clearance;
  const double line = pitch.half_length;
  // Of equally good targets the first one wins: on the other side of the ball than the shooter, which at a
  // kick-off already stands at an angle.
  const double first = shooter_y >= from.y ? -1.0 : 1.0;
  const std::optional<double> rolls_at = rollsAt(picture, from, edge);
  double best = 0.0, best_score = -1e9;
  for (int i = 0; i < (rolls_at ? 8 : 7); ++i) {
    const double y = i == 7 ? *rolls_at : first * edge * (3 - i) / 3;
    const auto priced = [&](double gap) {
      double score = gap - picture.tuning.middle_price * std::abs(y);
      if (rolls_at) score -= picture.tuning.course_price * std::abs(y - *rolls_at);
      return std::abs(y - last) < pitch.ball_radius ? score + pitch.ball_radius : score;
    };
    double gap = pitch.bodies;  // wider gaps are not better
    if (priced(gap) <= best_score) continue;
    const Vec2 way = Vec2{line, y} - from;
    const double length = norm(way);
    const Vec2 to = way / std::max(length, 1e-9);
    // A ball that comes slanting passes a post nearer. Beside a post, which does not move, a ball's radius is
    // room enough.
    const double room = to.x * (pitch.goal_half - std::abs(y)) - pitch.ball_radius;
    gap = std::min(gap, pitch.bodies * room / pitch.ball_radius);
    for (int j = 0; j < picture.seen.team_size; ++j) {
      if (!picture.opponentPresent(j)) continue;
      const Vec2 rel = intoFrame(to, picture.opponent(j).pose.position - from);
      if (rel.x < 0.0 || rel.x > length + pitch.robot_corner) continue;
      gap = std::min(gap, std::abs(rel.y) - pitch.front);
    }
    const double score = priced(gap);
    if (score > best_score) best_score = score, best = y;
  }
  return best;
}

bool isAtWall(const Pitch& pitch, Vec2 ball) {
  return std::abs(ball.y) > pitch.goal_half && wallClearance(pitch.field, ball) <= pitch.robot_corner;
}

Aim aimAt(const Pitch& pitch, Vec2 ball, Vec2 target) {
  Aim aim{ball, unitOr(target - ball, {1.0, 0.0}), false};
  if (!isAtWall(pitch, ball)) return aim;
  // Where a robot fits behind the ball, it strikes at the target. Elsewhere it would let go of the ball to
  // turn.
  const Vec2 behind = ball - aim.direction * pitch.front;
  if (wallClearance(pitch.field, behind) > pitch.robot_half) return aim;
  const Vec2 normal = nearestWallNormal(pitch.field, ball);
  const Vec2 along = wayAlong(normal, ball);
  aim.direction = unitOr(along - normal * pitch.tuning.lean, along);
  aim.contact = insideWalls(pitch.field, ball, pitch.robot_half);
  aim.wall = true;
  return aim;
}

}  // namespace fulbito::libero
