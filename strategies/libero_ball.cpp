#include "strategies/libero_ball.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito::libero {
namespace {

constexpr double kResting = 0.02;  // [m/s]

/// Rolling with its even loss for `dt`.
void roll(const BallModel& model, BallState& ball, double dt) {
  const double speed = norm(ball.velocity);
  if (speed <= model.stop_speed) {
    ball.velocity = ball.spin = {};
    return;
  }
  const double left = std::max(0.0, speed - model.roll_deceleration * dt);
  const double time = left > 0.0 ? dt : speed / model.roll_deceleration;
  ball.position += ball.velocity * ((speed + left) / 2 / speed * time);
  ball.velocity = ball.velocity * (left / speed);
  ball.spin = ball.velocity;
}

/// Free motion on the floor for `dt`: first sliding until velocity and spin have met, then rolling.
void moveOn(const BallModel& model, BallState& ball, double dt) {
  const Vec2 slip = ball.velocity - ball.spin;
  const double slip_speed = norm(slip);
  if (slip_speed > 1e-3) {
    const double meet = slip_speed * (1.0 - model.roll_keep) / model.slide_deceleration;
    const double time = std::min(dt, meet);
    const Vec2 pull = slip * (model.slide_deceleration / slip_speed);
    ball.position += ball.velocity * time - pull * (time * time / 2);
    ball.velocity -= pull * time;
    ball.spin += pull * (time * model.roll_keep / (1.0 - model.roll_keep));
    if (meet >= dt) return;
    ball.spin = ball.velocity;
    dt -= meet;
  }
  roll(model, ball, dt);
}

/// How far `p` is beyond the line at `limit` along the unit vector `out`; with its bounce.
void bounce(const BallModel& model, BallState& ball, Vec2 out, double limit) {
  const double beyond = dot(ball.position, out) - limit;
  const double speed = dot(ball.velocity, out);
  if (beyond <= 0.0) return;
  if (speed <= 0.0) {
    ball.position -= out * beyond;
    return;
  }
  const double e = model.wall_restitution;
  const Vec2 along = ball.velocity - out * speed;
  const double slide = norm(along);
  // Friction at the wall acts on the sliding ball until it stops along the wall, at most.
  const double drag = std::min(model.friction * (1.0 + e) * speed, slide);
  const Vec2 kept = slide > 1e-9 ? along * (1.0 - drag / slide) : Vec2{};
  ball.position -= out * (beyond * (1.0 + e));
  ball.velocity = kept - out * (e * speed);
  ball.spin -= out * (dot(ball.spin, out) * (1.0 - model.wall_spin_keep));
}

bool inMouth(const Pitch& pitch, Vec2 p) { return std::abs(p.y) < pitch.goal_half - pitch.ball_radius / 2; }

void bounceOffWalls(const Pitch& pitch, BallState& ball) {
  const double x = pitch.half_length - pitch.ball_radius, y = pitch.half_width - pitch.ball_radius;
  const double ax = std::abs(ball.position.x), ay = std::abs(ball.position.y);
  const double cut = pitch.half_length + pitch.half_width - pitch.corner - pitch.ball_radius * std::sqrt(2.0);
  if (ax <= x && ay <= y && ax + ay <= cut) return;
  const Vec2 sign{std::copysign(1.0, ball.position.x), std::copysign(1.0, ball.position.y)};
  if (inMouth(pitch, ball.position)) {
    bounce(pitch.ball, ball, {sign.x, 0.0}, x + pitch.goal_depth);
    return;
  }
  bounce(pitch.ball, ball, {sign.x, 0.0}, x);
  bounce(pitch.ball, ball, {0.0, sign.y}, y);
  bounce(pitch.ball, ball, sign / std::sqrt(2.0), cut / std::sqrt(2.0));
}

}  // namespace

BallState rolledOn(const Pitch& pitch, BallState ball, double dt) {
  moveOn(pitch.ball, ball, dt);
  bounceOffWalls(pitch, ball);
  return ball;
}

BallState SpinTracker::update(const Pitch& pitch, BallState seen) {
  if (begun_) {
    const BallState expected = rolledOn(pitch, last_, pitch.dt);
    seen.spin = expected.spin;
    // What rolled as expected and now agrees with its spin within the noise of an observation rolls.
    if (squaredNorm(seen.velocity - seen.spin) < 4e-4) seen.spin = seen.velocity;
  }
  begun_ = true;
  last_ = seen;
  return seen;
}

void BallForecast::compute(const Pitch& pitch, const BallState& ball) {
  now_ = ball;
  points_[0] = ball.position;
  resting_ = squaredNorm(ball.velocity) < kResting * kResting;
  if (resting_) {
    points_.fill(ball.position);
    return;
  }
  BallState moving = ball;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    moving = rolledOn(pitch, moving, kStep);
    points_[i] = moving.position;
  }
}

Vec2 BallForecast::at(double time) const {
  const double steps = std::clamp(time / kStep, 0.0, static_cast<double>(kSteps) - 1e-9);
  const auto i = static_cast<std::size_t>(steps);
  const double part = steps - static_cast<double>(i);
  return points_[i] + (points_[i + 1] - points_[i]) * part;
}

}  // namespace fulbito::libero
