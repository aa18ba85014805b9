#include <algorithm>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

/// If the ball is deeper than the area's front, the point is in front of the area.
std::optional<Move> shadow(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = ballAhead(picture);
  const Vec2 goal = pitch.ownGoal();
  const double front = -pitch.half_length + pitch.area_front + pitch.bodies;
  const double x = std::max(front, ball.x - picture.tuning.behind);
  const double part = std::clamp((x - goal.x) / std::max(pitch.ball_radius, ball.x - goal.x), 0.0, 1.0);
  const double most = ball.x < front + pitch.bodies
                          ? pitch.area_half - pitch.bodies
                          : pitch.half_width - pitch.robot_corner - pitch.tuning.clearance;
  return standBy(picture, robot, {x, std::clamp(ball.y * part, -most, most)}, "our goal must be covered");
}

}  // namespace fulbito::libero::support
