#include <algorithm>
#include <cmath>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

/// If the ball is deeper than the area's front, the point is in front of the area. A second robot stands
/// farther back, on the side away from the ball.
std::optional<Move> shadow(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = ballAhead(picture);
  const Vec2 goal = pitch.ownGoal();
  const double front = -pitch.half_length + pitch.area_front + pitch.bodies;
  const bool second = picture.rank[static_cast<std::size_t>(robot)] > 0;
  const double x = std::max(front, ball.x - (second ? 2 : 1) * picture.tuning.behind);
  const double part = std::clamp((x - goal.x) / std::max(pitch.ball_radius, ball.x - goal.x), 0.0, 1.0);
  const double most = ball.x < front + pitch.bodies
                          ? pitch.area_half - pitch.bodies
                          : pitch.half_width - pitch.robot_corner - pitch.tuning.clearance;
  const double aside = second ? -std::copysign(4 * pitch.robot_half, ball.y) : 0.0;
  const double y = std::clamp(ball.y * part + aside, -most, most);
  return standBy(picture, robot, {x, y}, "our goal must be covered");
}

}  // namespace fulbito::libero::support
