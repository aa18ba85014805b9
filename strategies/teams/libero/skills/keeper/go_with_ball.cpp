#include <algorithm>
#include <cmath>

#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

/// Whether a ball at `y` [m] from the keeper's middle that slides along its face at `across` [m/s] leaves the
/// face before the keeper, from rest, is as fast.
bool isTooFast(const Pitch& pitch, double y, double across) {
  const double time = (pitch.robot_half - std::copysign(1.0, across) * y) / std::abs(across);
  return pitch.acceleration * time < std::abs(across);
}

}  // namespace

/// A ball that touches the keeper's face at an angle keeps most of its speed along the face, and its spin
/// presses it toward the goal. The keeper starts just before the touch; starting after the ball has passed
/// would be 0.1 s late. Where the ball is too fast for that, the keeper turns once the ball is past its
/// middle, so that this half of the face throws the ball out.
std::optional<Move> goWithBall(const Picture& picture, int robot, Memory& /*memory*/) {
  const Tuning& tuning = picture.tuning;
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const BallState& ball = picture.ball.now();
  const Vec2 rel = picture.ballFrom(robot);
  const double gap = rel.x - pitch.front;
  const double across = ball.velocity.y;
  if (rel.x < 0.0 || gap > std::max(tuning.clearance / 2, -tuning.look_ahead * ball.velocity.x) ||
      std::abs(across) < tuning.lies)
    return std::nullopt;
  const double time =
      ball.velocity.x < 0.0 ? std::clamp(-gap / ball.velocity.x, 0.0, tuning.look_ahead) : 0.0;
  const double ahead = rel.y + across * time;
  // It must first reach a ball that is farther out.
  if (std::abs(ahead) > pitch.robot_half) return std::nullopt;
  if (gap < tuning.clearance && ahead * across > 0.0 && isTooFast(pitch, ahead, across)) {
    return Move{.twist = {0.0, -std::copysign(pitch.turn_rate, across)},
                .reason = "turns out a ball that slides along the face"};
  }
  const double wanted = tuning.keeper_share * across + std::copysign(stoppableSpeed(pitch, ahead), ahead);
  // The keeper may go past the post with half of its body.
  const double most = pitch.goal_half + pitch.robot_half;
  const double room = std::max(0.0, most - std::copysign(1.0, wanted) * self.pose.position.y);
  const double speed = std::min({std::abs(wanted), pitch.speed, stoppableSpeed(pitch, room)});
  return Move{.twist = alongLine(pitch, self, keeperLine(pitch), std::copysign(speed, wanted)),
              .reason = "a slanting ball slides along the face"};
}

}  // namespace fulbito::libero::keeper
