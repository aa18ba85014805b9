#include <cmath>

#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

/// Any touch would push such a ball in. The keeper drives away from it along the line and waits there.
std::optional<Move> leaveBall(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kBehind = 0.025;  // [m] least distance of the ball's centre behind the keeper's
  constexpr double kDeep = 0.025;    // [m] greatest distance of the ball's centre in front of the goal line
  constexpr double kApart = 0.08;    // [m] distance along the line that the keeper drives away
  constexpr double kBeside = 0.045;  // [m] along the line; a ball farther off is beside the keeper
  constexpr double kPushed = 0.09;   // [m] from the ball's centre to that of an opponent that pushes it
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  const Vec2 rel = picture.ballFrom(robot);
  if (rel.x > -kBehind || ball.x > -pitch.half_length + kDeep || std::abs(ball.y) > pitch.goal_half)
    return std::nullopt;
  // A keeper that stays holds out a ball beside it that an opponent pushes from the other side.
  if (std::abs(rel.y) > kBeside && picture.opponentsNear(ball, kPushed) > 0) return std::nullopt;
  Move move{.reason = "the ball lies behind the keeper"};
  const double away = rel.y > 0.0 ? -1.0 : 1.0;
  if (std::abs(rel.y) < kApart)
    move.twist = alongLine(pitch, picture.own(robot), keeperLine(pitch), away * pitch.speed);
  return move;
}

}  // namespace fulbito::libero::keeper
