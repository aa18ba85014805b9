#include "strategies/prediction/ball_tracker.hpp"

#include <algorithm>

namespace fulbito {
namespace {

/// The spin [m/s] after the ball has moved on the floor for `dt` [s].
Vec2 spinAfter(const BallModel& model, const BallState& ball, double dt) {
  const Vec2 slip = ball.velocity - ball.spin;
  const double speed = norm(slip);
  const double gain = model.slide_deceleration / (1.0 - model.roll_keep) * dt;
  if (speed <= gain) return model.roll_keep * ball.velocity + (1.0 - model.roll_keep) * ball.spin;
  return ball.spin + slip * (gain * model.roll_keep / speed);
}

}  // namespace

BallState BallTracker::update(const BallCourse& course, BallState seen, double dt) {
  constexpr double kLeastJump = 0.02;  // [m/s] beyond what friction explains: the ball hit something
  constexpr double kLeastSlip = 0.02;  // [m/s]
  seen.spin = seen.velocity;
  if (known_) {
    const BallModel& model = course.ball;
    Vec2 spin = spinAfter(model, last_, dt);
    const Vec2 change = seen.velocity - last_.velocity;
    const double jump = norm(change) - model.slide_deceleration * dt;
    const double reach = norm(last_.velocity) * dt + 0.005;
    if (jump > kLeastJump && !course.walls.isFree(seen.position, reach)) {
      const Vec2 normal = change / norm(change);
      spin -= normal * (dot(spin, normal) * (1.0 - model.wall_spin_keep));
    }
    if (norm(seen.velocity - spin) > kLeastSlip) seen.spin = spin;
  }
  last_ = seen;
  known_ = true;
  return seen;
}

}  // namespace fulbito
