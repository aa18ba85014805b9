#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {
namespace {

/// Whether the ball is stuck in their half where robots cannot shove each other. It is about to become a free
/// ball, at which all robots but the takers stay where they are.
bool isFreeBallNear(const Picture& picture, Vec2 ball) {
  return !picture.pitch.shoves && picture.stuck > picture.tuning.patience && ball.x > 0.0;
}

bool isForward(const Picture& picture, Vec2 ball) {
  return ball.x > picture.pitch.half_length / 2 * (1.0 - 2.0 * picture.tuning.aggression);
}

/// The place from which a robot shoots a ball that a spin throws across the field: it comes from behind and
/// meets the ball on the run. It looks at their goal, which is about where it runs. A ball that both robots
/// throw goes straight across, and there its face has a run-up of `behind`. One that a single robot throws
/// comes forward by twice `front`.
Move awaitThrow(const Picture& picture, int robot, Vec2 from) {
  const Pitch& pitch = picture.pitch;
  const double way = picture.tuning.behind;
  const Vec2 place{std::min(from.x - way - pitch.front, pitch.half_length - pitch.area_front - pitch.around),
                   farSide(from, picture.own(robot).pose.position) * way};
  return standBy(picture, robot, place, "the ball may be thrown across",
                 math::angleOf(pitch.theirGoal() - place));
}

}  // namespace

std::optional<Move> goForward(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  if (picture.rank[static_cast<std::size_t>(robot)] > 0) return std::nullopt;
  const Vec2 ball = ballAhead(picture), mark = pitch.field.free_ball_mark;
  const bool free_ball = isFreeBallNear(picture, ball);
  if (!free_ball && !isForward(picture, ball)) return std::nullopt;
  if (!pitch.shoves) return awaitThrow(picture, robot, {free_ball && mark.x > 0.0 ? mark.x : ball.x, ball.y});
  const Vec2 place{std::min(ball.x - 2 * pitch.bodies, pitch.half_length - pitch.area_front - pitch.around),
                   farSide(ball, picture.own(robot).pose.position) * pitch.goal_half};
  return standBy(picture, robot, place, "the ball is far forward");
}

}  // namespace fulbito::libero::support
