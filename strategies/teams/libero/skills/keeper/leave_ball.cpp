#include <cmath>

#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

/// Any touch would push such a ball in. The keeper drives away from it along the line and waits there.
std::optional<Move> leaveBall(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  const Vec2 rel = picture.ballFrom(robot);
  if (rel.x > -pitch.ball_radius || ball.x > -pitch.half_length + pitch.ball_radius ||
      std::abs(ball.y) > pitch.goal_half)
    return std::nullopt;
  // A keeper that stays holds out a ball beside it that an opponent pushes from the other side.
  if (std::abs(rel.y) > pitch.robot_half &&
      picture.opponentsNear(ball, pitch.touch + pitch.tuning.clearance) > 0)
    return std::nullopt;
  Move move{.reason = "the ball lies behind the keeper"};
  const double away = rel.y > 0.0 ? -1.0 : 1.0;
  if (std::abs(rel.y) < pitch.touch)
    move.twist = alongLine(pitch, picture.own(robot), keeperLine(pitch), away * pitch.speed);
  return move;
}

}  // namespace fulbito::libero::keeper
