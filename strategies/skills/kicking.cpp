#include "strategies/skills/kicking.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {

bool isKicking(const Observation& now, std::size_t i, const KickLimits& limits) {
  constexpr double kAway = 0.12, kFirst = 0.3;  // [m], [s] in which the ball is still at its place
  const bool kick = now.restart == RestartKind::kPenalty || now.restart == RestartKind::kKickOff;
  if (!kick || !now.restart_is_ours || now.since_restart > limits.longest) return false;
  const Pose2& pose = now.own[i].state.pose;
  const Vec2 to_ball = now.ball.position - pose.position;
  if (std::abs(math::wrapAngle(math::angleOf(to_ball) - pose.heading)) >= limits.straight) return false;
  return norm(to_ball) < kAway || now.since_restart < kFirst;
}

}  // namespace fulbito
