#include <cmath>

#include "strategies/skills/wall_play.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

/// An opponent that arrives at full speed shoves a keeper along the line, however it drives, and the ball
/// goes in behind it at the post. A spin gives way and throws the ball out of the squeeze. Within the mouth,
/// a keeper that spins would let the ball in.
std::optional<Move> spinOut(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  if (!pitch.shoves || !ballAlongEndWall(picture, pitch.goal_half + pitch.touch)) return std::nullopt;
  const Vec2 ball = picture.ball.now().position, rel = picture.ballFrom(robot);
  const bool beside = norm(rel) < pitch.touch && std::abs(rel.y) > std::abs(rel.x);
  if (!beside || picture.opponentsNear(ball, pitch.touch + pitch.front) == 0) return std::nullopt;
  return Move{.twist = {0.0, spinSense({}, rel, {1.0, 0.0}) * pitch.turn_rate},
              .reason = "an opponent presses on the ball at the post",
              .ball = ball};
}

}  // namespace fulbito::libero::keeper
