#include "strategies/teams/libero/situation/pitch.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito::libero {

Pitch::Pitch(const MatchInfo& info)
    : half_length(info.field.length / 2),
      half_width(info.field.width / 2),
      goal_half(info.field.goal_width / 2),
      corner(info.field.corner),
      area_half(info.field.goal_area_width / 2),
      area_depth(info.field.goal_area_depth),
      arc_half(info.field.goal_area_arc_width / 2),
      arc_depth(info.field.goal_area_arc_depth),
      big_area_depth(info.field.big_area_depth),
      circle(info.field.centre_circle_radius),
      ball_radius(info.ball.radius),
      robot_half(std::max(info.robot.length, info.robot.width) / 2),
      robot_corner(info.robot.circumradius()),
      speed(info.robot.maxSpeed()),
      acceleration(info.robot.wheel_acceleration),
      turning(info.robot.turnAcceleration()),
      half_track(info.robot.axle_track / 2),
      wheel_radius(info.robot.wheel_radius),
      motors(info.robot, info.physics.controlPeriod()),
      team_size(info.rules.team_size) {}

Vec2 Pitch::inside(Vec2 p, double margin) const {
  const double x = half_length - margin, y = half_width - margin;
  p.x = std::clamp(p.x, -x, x);
  p.y = std::clamp(p.y, -y, y);
  // The corner cut: |x| + |y| may not exceed the line that lies `margin` inside it.
  const double beyond =
      std::abs(p.x) + std::abs(p.y) - (half_length + half_width - corner - margin * std::sqrt(2.0));
  if (beyond > 0.0) p -= Vec2{std::copysign(beyond / 2, p.x), std::copysign(beyond / 2, p.y)};
  return p;
}

}  // namespace fulbito::libero
