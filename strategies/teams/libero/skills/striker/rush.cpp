#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether at an own penalty an opponent leaves its goal toward the ball. In the first 0.05 s, when its
/// motion cannot be seen yet, the answer is yes.
bool keeperRunsOut(const Picture& picture) {
  const Observation& seen = picture.seen;
  if (seen.restart != RestartKind::kPenalty || !seen.restart_is_ours || seen.since_restart > kDispute)
    return false;
  if (seen.since_restart < 0.05) return true;
  for (int i = 0; i < seen.team_size; ++i) {
    if (!picture.opponentPresent(i)) continue;
    const RobotState& other = picture.opponent(i);
    if (other.pose.position.x < picture.ball.now().position.x - 0.1) continue;
    if (other.pose.position.x < picture.pitch.half_length - 0.12 || other.velocity.x < -0.15) return true;
  }
  return false;
}

/// Whether a restart has just begun at which the first touch matters.
bool firstTouchCounts(const Observation& seen) {
  if (seen.restart == RestartKind::kKickOff) return seen.since_restart < 0.4;
  return seen.restart == RestartKind::kGoalKick && !seen.restart_is_ours && seen.since_restart < 0.5;
}

}  // namespace

/// A quick touch matters more than its direction: a robot that drives round the ball would lose it.
std::optional<Move> rush(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kAtBall = 0.055;  // [m] nearer than this, the robot has touched it
  const bool runs_out = keeperRunsOut(picture);
  const bool touched = squaredNorm(picture.ballFrom(robot)) < kAtBall * kAtBall;
  if (!runs_out && (touched || !firstTouchCounts(picture.seen))) return std::nullopt;
  const Vec2 touch = firstTouch(picture);
  return Move{.twist = passThrough(picture.own(robot), touch, picture.pitch.speed),
              .reason = runs_out ? "their keeper runs out" : "the first touch counts",
              .ball = touch};
}

}  // namespace fulbito::libero::striker
