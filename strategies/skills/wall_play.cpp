#include "strategies/skills/wall_play.hpp"

#include <algorithm>

namespace fulbito {

double spinSense(Vec2 robot, Vec2 ball, Vec2 wanted) {
  return cross(ball - robot, wanted) >= 0.0 ? 1.0 : -1.0;
}

std::optional<double> SpinKick::update(const FieldGeometry& field, double ball_radius,
                                       const RobotState& robot, const BallState& ball, Vec2 wanted,
                                       bool allowed, double dt, const SpinSettings& settings) {
  const double gap = distance(robot.pose.position, ball.position);
  rest_ = std::max(0.0, rest_ - dt);
  if (time_ > 0.0) {
    time_ += dt;
    if (time_ < settings.longest && gap < settings.release) return sense_;
    time_ = 0.0;
    rest_ = settings.lock_out;
    return std::nullopt;
  }
  const bool pinned = wallClearance(field, ball.position) < ball_radius + settings.wall;
  const bool slow = norm(ball.velocity) < settings.slow;
  if (!allowed || !pinned || !slow || rest_ > 0.0 || gap > settings.reach) return std::nullopt;
  sense_ = spinSense(robot.pose.position, ball.position, wanted);
  time_ = dt;
  return sense_;
}

}  // namespace fulbito
