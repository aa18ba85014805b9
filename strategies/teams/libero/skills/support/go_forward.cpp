#include <algorithm>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

std::optional<Move> goForward(const Picture& picture, int robot, Memory& /*memory*/) {
  const Vec2 ball = ballAhead(picture);
  if (picture.rank[static_cast<std::size_t>(robot)] > 0 || ball.x <= 0.45 - 0.6 * picture.tuning.aggression)
    return std::nullopt;
  const double far_side = farSide(ball, picture.own(robot).pose.position);
  const Vec2 place{std::min(ball.x - 0.2, picture.pitch.half_length - 0.35), far_side * 0.18};
  return standBy(picture, robot, place, "the ball is far forward");
}

}  // namespace fulbito::libero::support
