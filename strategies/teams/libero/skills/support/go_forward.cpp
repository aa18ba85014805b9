#include <algorithm>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

std::optional<Move> goForward(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = ballAhead(picture);
  if (picture.rank[static_cast<std::size_t>(robot)] > 0 ||
      ball.x <= pitch.half_length / 2 * (1.0 - 2.0 * picture.tuning.aggression))
    return std::nullopt;
  const double far_side = farSide(ball, picture.own(robot).pose.position);
  // Spins throw the ball across the field, so there the robot waits level with it.
  const double back = pitch.shoves ? 2 * pitch.bodies : 0.0;
  const Vec2 place{std::min(ball.x - back, pitch.half_length - pitch.area_front - pitch.around),
                   far_side * pitch.goal_half};
  return standBy(picture, robot, place, "the ball is far forward");
}

}  // namespace fulbito::libero::support
