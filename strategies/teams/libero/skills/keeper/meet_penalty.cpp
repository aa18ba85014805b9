#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

std::optional<Move> meetPenalty(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kEarly = 0.8;     // [s]
  constexpr double kInFront = 0.04;  // [m] by which the ball must still be farther out than the keeper
  constexpr double kApart = 0.06;    // [m] from the keeper's centre to the ball
  constexpr double kAhead = 0.12;    // [s]
  const Observation& seen = picture.seen;
  if (seen.restart != RestartKind::kPenalty || seen.restart_is_ours || seen.since_restart >= kEarly)
    return std::nullopt;
  const Vec2 rel = picture.ballFrom(robot);
  if (rel.x <= kInFront || squaredNorm(rel) <= kApart * kApart) return std::nullopt;
  // The keeper drives toward the taker, since it covers more of the goal the nearer it is to the ball.
  const Vec2 meet = picture.ball.now().position + picture.ball.now().velocity * kAhead;
  return Move{.twist = passThrough(picture.pitch, picture.own(robot), meet),
              .reason = "their penalty has just begun",
              .ball = meet};
}

}  // namespace fulbito::libero::keeper
