#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

/// The ball leaves only as fast as the keeper that pushes it. A keeper that slowed down or turned back at the
/// first touch would lay it down for the opponents, in front of the own goal.
std::optional<Move> goalKick(const Picture& picture, int robot, Memory& /*memory*/) {
  const Observation& seen = picture.seen;
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const bool begun = seen.restart == RestartKind::kGoalKick && seen.restart_is_ours &&
                     seen.since_restart < picture.tuning.patience;
  const double out = -pitch.half_length + pitch.area_front + pitch.robot_corner;
  if (!begun || self.pose.position.x > out || picture.ballFrom(robot).x <= 0.0) return std::nullopt;
  const Vec2 ball = picture.ball.now().position;
  return Move{.twist = passThrough(pitch, self, ball), .reason = "our goal kick", .ball = ball};
}

}  // namespace fulbito::libero::keeper
