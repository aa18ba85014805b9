#include <algorithm>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

/// Nobody else stops a ball that comes out on the opponents' side.
std::optional<Move> secondBall(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kCrowd = 0.25;  // [m]
  const Vec2 ball = ballAhead(picture);
  if (picture.rank[static_cast<std::size_t>(robot)] > 0 || picture.pitch.isLarge() ||
      picture.opponentsNear(ball, kCrowd) < 2)
    return std::nullopt;
  const Vec2 place{std::min(ball.x + 0.3, picture.pitch.half_length - 0.35),
                   std::clamp(ball.y * 0.4, -0.3, 0.3)};
  return standBy(picture, robot, place, "two opponents crowd the ball");
}

}  // namespace fulbito::libero::support
