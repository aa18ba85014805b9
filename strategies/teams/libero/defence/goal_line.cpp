#include "strategies/teams/libero/defence/goal_line.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::libero {

std::optional<double> crossing(const Picture& picture, double line) {
  constexpr int kSoon = 24;  // steps of the forecast
  Vec2 before = picture.ball.sample(0);
  if (picture.ball.resting() || before.x < line) return std::nullopt;
  for (int i = 1; i <= kSoon; ++i) {
    const Vec2 after = picture.ball.sample(i);
    if (after.x <= line) {
      const double part = (before.x - line) / std::max(1e-9, before.x - after.x);
      return before.y + (after.y - before.y) * part;
    }
    before = after;
  }
  return std::nullopt;
}

bool shotComes(const Picture& picture) {
  constexpr double kSlowest = 0.3;  // [m/s]
  constexpr double kPast = 0.03;    // [m] past a post
  if (squaredNorm(picture.ball.now().velocity) <= kSlowest * kSlowest) return false;
  const auto shot = crossing(picture, -picture.pitch.half_length);
  return shot && std::abs(*shot) < picture.pitch.goal_half + kPast;
}

bool mustSave(const Picture& picture, int robot) {
  const Pitch& pitch = picture.pitch;
  const auto shot = crossing(picture, -pitch.half_length);
  if (!shot || std::abs(*shot) > pitch.goal_half + 0.02) return false;
  return picture.own(robot).pose.position.x < -pitch.half_length + 0.3 &&
         picture.ball.now().position.x > picture.own(robot).pose.position.x;
}

Twist alongLine(const RobotState& self, double line, double speed) {
  const double dx = line - self.pose.position.x;
  const double lean = std::clamp(dx * 6.0, -0.4, 0.4) * std::min(1.0, std::abs(speed) / 0.2);
  const double along = speed >= 0.0 ? math::kPi / 2 - lean : -math::kPi / 2 + lean;
  const double error = foldedError(along, self.pose.heading);
  const double face = std::abs(math::wrapAngle(along - self.pose.heading)) > math::kPi / 2 ? -1.0 : 1.0;
  return {face * std::abs(speed) * std::max(0.0, math::cos(error)), std::clamp(18.0 * error, -20.0, 20.0)};
}

double stoppableSpeed(const Pitch& pitch, double way, double gain) {
  return std::min(stoppingSpeed(0.8 * pitch.braking, std::abs(way)), gain * std::abs(way));
}

Twist slideTo(const Picture& picture, const RobotState& self, double line, double y) {
  const Pitch& pitch = picture.pitch;
  const double dx = line - self.pose.position.x, dy = y - self.pose.position.y;
  const Vec2 rel = picture.ball.now().position - self.pose.position;
  if (dx > 0.02 && squaredNorm(rel) < 0.13 * 0.13 && rel.x > 0.0) {
    // The keeper is behind its line with the ball in front of it. It stays parallel to the line in front of
    // the ball, because a turn would let the ball in.
    const double along = self.pose.heading >= 0.0 ? math::kPi / 2 : -math::kPi / 2;
    const double ahead = picture.ball.at(0.05).y - self.pose.position.y;
    return {std::copysign(1.0, self.pose.heading) * std::clamp(15.0 * ahead, -pitch.speed, pitch.speed),
            std::clamp(12.0 * foldedError(along, self.pose.heading), -8.0, 8.0)};
  }
  if (std::abs(dx) > 0.06 || std::abs(dy) > 0.35)
    return restAt(pitch, self, {line, y}, math::kPi / 2, pitch.ball_radius);
  return alongLine(self, line, std::copysign(std::min(pitch.speed, stoppableSpeed(pitch, dy, 20.0)), dy));
}

}  // namespace fulbito::libero
