#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether the referee is going to give a free ball for a ball that a robot holds. Some rules give none for
/// minutes, in which even a ball that creeps a circle's radius in each `patience` comes to their end. Some
/// matches have no referee.
bool awaitsFreeBall(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const double patience = picture.tuning.patience;
  return pitch.stuck_time * pitch.stuck_radius < pitch.half_length * patience &&
         picture.stuck < pitch.stuck_time + patience;
}

}  // namespace

/// Where the robot cannot push the opponent away, a free ball in their half may be worth more than the slow
/// way along the wall. A robot that pushed on would creep out of the circle in which a ball counts as stuck.
std::optional<Move> hold(const Picture& picture, int robot, Memory& memory) {
  const BallState& ball = picture.ball.now();
  if (picture.pitch.shoves || !picture.free_balls_pay || ball.position.x < picture.pitch.stuck_radius ||
      !isPressed(picture, robot, shotOf(picture, robot, memory.shot).aim) || !awaitsFreeBall(picture))
    return std::nullopt;
  return Move{
      .twist = holdBall(picture, robot), .reason = "it is held for the free ball", .ball = ball.position};
}

}  // namespace fulbito::libero::striker
