#include "engine/sim/ball_motion.hpp"

namespace fulbito {
namespace {

BallMotion rolling(const BallModel& ball, Vec2 velocity, double dt) {
  const double speed = norm(velocity);
  const double left = speed - ball.roll_deceleration * dt;
  if (left <= ball.stop_speed) return {};
  const Vec2 slower = velocity * (left / speed);
  return {slower, slower};
}

}  // namespace

BallMotion afterFloor(const BallModel& ball, BallMotion motion, double dt) {
  const double keep = ball.roll_keep;
  const Vec2 slip = motion.velocity - motion.spin;
  const double slip_speed = norm(slip);
  const double loss = ball.slide_deceleration * dt;
  // The slip shrinks by loss / (1 - keep) per step; if that would reverse it, the ball rolls.
  if (slip_speed * (1.0 - keep) <= loss) {
    return rolling(ball, keep * motion.velocity + (1.0 - keep) * motion.spin, dt);
  }
  const Vec2 along = slip / slip_speed;
  return {motion.velocity - along * loss, motion.spin + along * (loss * keep / (1.0 - keep))};
}

Vec2 spinAfterWall(const BallModel& ball, Vec2 spin, Vec2 normal) {
  return spin - normal * (dot(spin, normal) * (1.0 - ball.wall_spin_keep));
}

}  // namespace fulbito
