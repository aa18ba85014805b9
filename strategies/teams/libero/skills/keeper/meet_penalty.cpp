#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

std::optional<Move> meetPenalty(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const Observation& seen = picture.seen;
  if (seen.restart != RestartKind::kPenalty || seen.restart_is_ours ||
      seen.since_restart >= picture.tuning.patience)
    return std::nullopt;
  const Vec2 rel = picture.ballFrom(robot);
  if (rel.x <= pitch.robot_half || norm(rel) <= pitch.front) return std::nullopt;
  // The keeper drives toward the taker, since it covers more of the goal the nearer it is to the ball.
  const Vec2 meet = picture.ball.now().position + picture.ball.now().velocity * pitch.turn_time;
  return Move{.twist = passThrough(pitch, picture.own(robot), meet),
              .reason = "their penalty has just begun",
              .ball = meet};
}

}  // namespace fulbito::libero::keeper
