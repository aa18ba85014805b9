#include <cmath>

#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

bool isOurPenalty(const Picture& picture) { return picture.isPenalty() && picture.seen.restart_is_ours; }

/// Whether at an own penalty an opponent leaves its goal toward the ball.
bool keeperRunsOut(const Picture& picture) {
  const Observation& seen = picture.seen;
  const Pitch& pitch = picture.pitch;
  if (!isOurPenalty(picture)) return false;
  for (int i = 0; i < seen.team_size; ++i) {
    if (!picture.opponentPresent(i)) continue;
    const RobotState& other = picture.opponent(i);
    if (other.pose.position.x < picture.ball.now().position.x - pitch.touch) continue;
    if (other.pose.position.x < pitch.half_length - pitch.around || other.velocity.x < -picture.tuning.lies)
      return true;
  }
  return false;
}

/// Whether at an own penalty a straight run of the robot sends the ball that lies there past a keeper in the
/// middle: nearer to a post than to the middle of the mouth.
bool runsAtCorner(const Picture& picture, int robot) {
  const double lies = picture.tuning.lies, goal_half = picture.pitch.goal_half;
  const BallState& ball = picture.ball.now();
  const Vec2 way = picture.ballFrom(robot);
  if (!isOurPenalty(picture) || way.x <= 0.0 || squaredNorm(ball.velocity) > lies * lies) return false;
  const double y = ball.position.y + way.y / way.x * (picture.pitch.half_length - ball.position.x);
  return std::abs(y) > goal_half / 2 && std::abs(y) < goal_half;
}

/// Whether a restart has just begun at which the first touch matters.
bool firstTouchCounts(const Picture& picture) {
  const Observation& seen = picture.seen;
  const bool theirs = seen.restart == RestartKind::kGoalKick && !seen.restart_is_ours;
  return (theirs || seen.restart == RestartKind::kKickOff) && seen.since_restart < picture.tuning.rush_time;
}

}  // namespace

/// A quick touch matters more than its direction: a robot that drives round the ball would lose it.
std::optional<Move> rush(const Picture& picture, int robot, Memory& /*memory*/) {
  const bool runs_out = keeperRunsOut(picture), shoots = runsAtCorner(picture, robot);
  const bool touched = norm(picture.ballFrom(robot)) < picture.pitch.front;
  if (!runs_out && !shoots && (touched || !firstTouchCounts(picture))) return std::nullopt;
  const Vec2 touch = firstTouch(picture);
  const char* reason = shoots     ? "at the corner"
                       : runs_out ? "their keeper runs out"
                                  : "the first touch counts";
  return Move{
      .twist = passThrough(picture.pitch, picture.own(robot), touch), .reason = reason, .ball = touch};
}

}  // namespace fulbito::libero::striker
