#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

/// Whether an opponent can reach the ball within `time` [s].
bool opponentArrives(const Picture& picture, double time) {
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.opponentPresent(i) &&
        timeToReach(picture.pitch.pace, picture.opponent(i), picture.ball.now().position) < time)
      return true;
  }
  return false;
}

}  // namespace

/// A keeper that waits would be pushed in with the ball by the next opponent that runs at it.
std::optional<Move> pushOut(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const BallState& ball = picture.ball.now();
  const Vec2 rel = picture.ballFrom(robot);
  if (self.pose.position.x > -pitch.half_length + pitch.ball_radius ||
      std::abs(ball.position.y) > pitch.goal_half)
    return std::nullopt;
  if (rel.x < pitch.ball_radius || std::abs(rel.y) > pitch.front || norm(rel) > pitch.around)
    return std::nullopt;
  if (std::abs(foldedError(0.0, self.pose.heading)) > 2 * pitch.tuning.turn_in &&
      (norm(ball.velocity) > pitch.tuning.rolls || opponentArrives(picture, pitch.turn_time)))
    return std::nullopt;
  const double side = ball.position.y >= 0.0 ? pitch.tuning.lean : -pitch.tuning.lean;
  const double heading = math::angleOf(unitOr(rel, {1.0, 0.0}) + Vec2{0.0, side});
  return Move{.twist = alongHeading(pitch, self, heading, pitch.speed),
              .reason = "the keeper was pushed into the goal",
              .ball = ball.position};
}

}  // namespace fulbito::libero::keeper
