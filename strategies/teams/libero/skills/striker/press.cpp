#include "strategies/teams/libero/attack/press.hpp"

#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether an opponent presses from the other side against the ball that the robot pushes roughly in the
/// wanted direction.
bool headOn(const Picture& picture, Vec2 rel, const Aim& aim) {
  const double near = norm(rel);
  if (aim.wall || near > picture.pitch.touch || dot(rel, aim.direction) < 0.5 * near) return false;
  const Vec2 opposite = picture.ball.now().position + unitOr(rel, {}) * picture.pitch.front;
  return picture.opponentsNear(opposite, picture.pitch.ball_radius + picture.tuning.clearance) > 0;
}

}  // namespace

std::optional<Move> press(const Picture& picture, int robot, Memory& memory) {
  if (!headOn(picture, picture.ballFrom(robot), shotOf(picture, robot, memory.shot).aim)) return std::nullopt;
  return Move{.twist = pressOn(picture, robot, memory.press),
              .reason = "an opponent presses from the other side",
              .ball = firstTouch(picture)};
}

}  // namespace fulbito::libero::striker
