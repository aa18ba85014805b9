#include <algorithm>
#include <cmath>

#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

/// A ball that touches the keeper's face at an angle keeps most of its speed along the face, and its spin
/// presses it toward the goal. The keeper starts just before the touch; starting after the ball has passed
/// would be 0.1 s late.
std::optional<Move> goWithBall(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kSoon = 0.04;    // [s] before the touch
  constexpr double kFace = 0.04;    // [m] from the keeper's centre; it must first reach a ball farther out
  constexpr double kAcross = 0.2;   // [m/s] the keeper waits for slower balls
  constexpr double kShare = 0.8;    // share of the ball's speed across that it keeps along the face
  constexpr double kRoom = 0.24;    // [m] greatest |y| of the keeper, slightly past the post
  constexpr double kTouch = 0.002;  // [m]
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const BallState& ball = picture.ball.now();
  const Vec2 rel = picture.ballFrom(robot);
  const double gap = rel.x - pitch.robot_half - pitch.ball_radius;
  const double across = ball.velocity.y;
  if (rel.x < 0.0 || gap > std::max(kTouch, -kSoon * ball.velocity.x) || std::abs(across) < kAcross)
    return std::nullopt;
  const double time = ball.velocity.x < 0.0 ? std::clamp(-gap / ball.velocity.x, 0.0, kSoon) : 0.0;
  const double ahead = rel.y + across * time;
  if (std::abs(ahead) > kFace) return std::nullopt;
  const double wanted = kShare * across + std::copysign(stoppableSpeed(pitch, ahead, 15.0), ahead);
  const double room = std::max(0.0, kRoom - std::copysign(1.0, wanted) * self.pose.position.y);
  const double speed = std::min({std::abs(wanted), pitch.speed, stoppableSpeed(pitch, room, 20.0)});
  return Move{.twist = alongLine(self, keeperLine(pitch), std::copysign(speed, wanted)),
              .reason = "a slanting ball slides along the face"};
}

}  // namespace fulbito::libero::keeper
