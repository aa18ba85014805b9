#include <algorithm>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {
namespace {

/// Whether the ball is far enough forward. One that is stuck in their half, where robots cannot shove each
/// other, is about to become a free ball, and all robots but the takers stay where they are.
bool isForward(const Picture& picture, Vec2 ball) {
  if (!picture.pitch.shoves && picture.stuck > picture.tuning.patience && ball.x > 0.0) return true;
  return ball.x > picture.pitch.half_length / 2 * (1.0 - 2.0 * picture.tuning.aggression);
}

}  // namespace

std::optional<Move> goForward(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = ballAhead(picture);
  if (picture.rank[static_cast<std::size_t>(robot)] > 0 || !isForward(picture, ball)) return std::nullopt;
  const double far_side = farSide(ball, picture.own(robot).pose.position);
  // Where spins throw the ball across the field, the robot comes from behind and meets it on the run.
  const double back = pitch.shoves ? 2 * pitch.bodies : picture.tuning.behind;
  const double wide = pitch.shoves ? pitch.goal_half : picture.tuning.behind;
  const Vec2 place{std::min(ball.x - back, pitch.half_length - pitch.area_front - pitch.around),
                   far_side * wide};
  return standBy(picture, robot, place, "the ball is far forward");
}

}  // namespace fulbito::libero::support
