#include "strategies/skills/shot_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kEverything = 1e9;

/// y at which the ray from `ball` along `direction` meets the line x = `goal_x`; huge, with the sign of
/// `direction.y`, if the ray does not meet it.
double meetsLine(Vec2 ball, Vec2 direction, double goal_x) {
  if (direction.x <= 1e-9) return std::copysign(kEverything, direction.y);
  return ball.y + (goal_x - ball.x) * direction.y / direction.x;
}

/// How far [m] a blocker moves toward a ball that needs `time` [s] to reach it.
double reachOf(const ShotModel& model, double time) {
  constexpr double kFarthest = 0.15;  // [m] limit, since longer saves succeed only by chance
  const double running = std::max(0.0, time - model.reaction);
  return std::min(kFarthest, 0.5 * model.acceleration * running * running);
}

}  // namespace

FreeMouth::FreeMouth(const FieldGeometry& field, const ShotModel& model, Vec2 ball,
                     std::span<const ShotBlocker> blockers) {
  const double goal_x = field.length / 2, half = field.goal_width / 2 - model.ball_radius;
  if (half <= 0.0 || ball.x >= goal_x) return;
  intervals_[count_++] = {-half, half};
  for (const ShotBlocker& blocker : blockers) {
    const Vec2 to = blocker.position - ball;
    const double away = norm(to);
    if (to.x <= 0.0 || blocker.position.x > goal_x + blocker.radius || away < 1e-9) continue;
    const double wide = blocker.radius + model.ball_radius + reachOf(model, away / model.speed);
    const double sine = std::min(1.0, wide / away), cosine = std::sqrt(1.0 - sine * sine);
    const Vec2 ahead = to / away, aside = perp(ahead);
    remove(meetsLine(ball, ahead * cosine - aside * sine, goal_x),
           meetsLine(ball, ahead * cosine + aside * sine, goal_x));
  }
}

void FreeMouth::remove(double low, double high) {
  std::array<MouthInterval, kMost> left{};
  std::size_t count = 0;
  const auto keep = [&](double from, double to) {
    if (from < to && count < kMost) left[count++] = {from, to};
  };
  for (const MouthInterval& interval : intervals()) {
    keep(interval.low, std::min(interval.high, low));
    keep(std::max(interval.low, high), interval.high);
  }
  intervals_ = left;
  count_ = count;
}

std::optional<Vec2> bestShot(const FieldGeometry& field, const ShotModel& model, Vec2 ball,
                             std::span<const ShotBlocker> blockers) {
  const FreeMouth mouth(field, model, ball, blockers);
  const double goal_x = field.length / 2;
  MouthInterval best;
  double widest = 0.0;
  for (const MouthInterval& interval : mouth.intervals()) {
    const Vec2 low = Vec2{goal_x, interval.low} - ball, high = Vec2{goal_x, interval.high} - ball;
    const double angle = math::atan2(cross(low, high), dot(low, high));
    if (angle > widest) widest = angle, best = interval;
  }
  if (widest <= 0.0) return std::nullopt;
  const ShotBlocker* last = nullptr;
  for (const ShotBlocker& blocker : blockers) {
    if (last == nullptr || blocker.position.x > last->position.x) last = &blocker;
  }
  constexpr double kMoving = 0.1;  // [m/s]
  double share = 0.5;
  if (last != nullptr && std::abs(last->velocity.y) > kMoving) share = last->velocity.y > 0.0 ? 0.4 : 0.6;
  return Vec2{goal_x, best.low + share * best.width()};
}

}  // namespace fulbito
