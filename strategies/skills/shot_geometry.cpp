#include "strategies/skills/shot_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/math.hpp"

namespace fulbito {
namespace {

constexpr double kEverything = 1e9;

/// y at which the ray from `ball` along `direction` meets the line x = `goal_x`; far up or down when it never
/// does.
double meetsLine(Vec2 ball, Vec2 direction, double goal_x) {
  if (direction.x <= 1e-9) return std::copysign(kEverything, direction.y);
  return ball.y + (goal_x - ball.x) * direction.y / direction.x;
}

/// How far a blocker comes to meet a ball that takes `time` [s] to it.
double reachOf(const ShotModel& model, double time) {
  constexpr double kFarthest = 0.15;  // [m] a longer run would be a save by chance
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

double chanceWithin(double half_angle, double spread) {
  if (half_angle <= 0.0) return 0.0;
  // The error function by Abramowitz & Stegun 7.1.26, within 1.5e-7.
  const double x = half_angle / (spread * std::sqrt(2.0));
  const double t = 1.0 / (1.0 + 0.3275911 * x);
  const double sum =
      t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return 1.0 - sum * math::exp(-x * x);
}

std::optional<Shot> bestShot(const FieldGeometry& field, const ShotModel& model, Vec2 ball,
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
  return Shot{{goal_x, best.low + share * best.width()}, widest / 2, chanceWithin(widest / 2, model.spread)};
}

namespace {

/// Where a ball struck toward `direction` passes the line x = target.x after one bounce off the side wall.
std::optional<BallPrediction::Crossing> strike(const BallCourse& course, Vec2 ball, Vec2 direction,
                                               double speed, Vec2 target) {
  BallPrediction prediction;
  prediction.predict(course, {ball, direction * speed, direction * speed}, 4.0);
  const double side = target.x >= ball.x ? 1.0 : -1.0;
  const auto crossing = prediction.crossing(target, {side, 0.0});
  if (!crossing || crossing->bounces != 1) return std::nullopt;
  return crossing;
}

}  // namespace

std::optional<BankShot> bankShot(const BallCourse& course, const FieldGeometry& field, Vec2 ball, Vec2 target,
                                 bool upper, double speed) {
  const BallModel& model = course.ball;
  const double wall = (field.width / 2 - model.radius) * (upper ? 1.0 : -1.0);
  // Of the speed toward the wall, when the spin has settled; and what the wall's friction takes along it, per
  // speed toward it.
  const double kept =
      model.roll_keep * model.wall_restitution - (1.0 - model.roll_keep) * model.wall_spin_keep;
  const double lost = model.roll_keep * model.friction * (1.0 + model.wall_restitution);
  const double depth = (wall - target.y) / kept;
  if (!(kept > 0.0) || std::abs(depth) < 1e-6) return std::nullopt;
  const double side = target.x >= ball.x ? 1.0 : -1.0;
  Vec2 mirrored{target.x + side * std::abs(depth) * lost, wall + depth};
  std::optional<BallPrediction::Crossing> crossing;
  Vec2 direction;
  for (int i = 0; i < 4; ++i) {
    direction = unitOr(mirrored - ball, {1.0, 0.0});
    crossing = strike(course, ball, direction, speed, target);
    if (!crossing) return std::nullopt;
    // A ball that comes out too far from the wall was struck too steeply at it.
    mirrored.y += (crossing->place.y - target.y) / kept;
  }
  const double share = (wall - ball.y) / (direction.y == 0.0 ? 1e-9 : direction.y);
  return BankShot{direction, ball + direction * share, std::abs(crossing->place.y - target.y),
                  norm(crossing->velocity)};
}

}  // namespace fulbito
