#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

/// Where robots cannot shove each other, opponents that spin at a free ball throw it across, past our goal,
/// where a mate of theirs shoots it. The place is on our goal's side of the way of a ball that both throw,
/// which touches the robot there, and in the way of one that one robot throws.
std::optional<Move> guardThrow(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = ballAhead(picture), mark = pitch.field.free_ball_mark;
  // Until just before the free ball, our goal is covered.
  const bool soon = picture.stuck > pitch.stuck_time - picture.tuning.patience;
  if (pitch.shoves || !(soon || disputesFreeBall(picture)) || ball.x >= 0.0 || mark.x <= 0.0 ||
      picture.rank[static_cast<std::size_t>(robot)] > 0)
    return std::nullopt;
  const double side = std::copysign(1.0, ball.y);
  const Vec2 place{-mark.x - pitch.front, side * (mark.y - 2 * pitch.bodies)};
  return standBy(picture, robot, place, "the ball may be thrown past our goal", side * math::kPi / 2);
}

}  // namespace fulbito::libero::support
