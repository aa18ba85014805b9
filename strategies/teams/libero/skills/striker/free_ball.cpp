#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether an opponent is near enough to take the ball from a robot that turns away to aim. Otherwise the
/// robot aims, since a straight push sends the ball into the opponents' corner, from where it returns along
/// the wall.
bool contested(const Picture& picture) {
  return picture.seen.since_restart < picture.pitch.turn_time ||
         picture.opponentsNear(picture.ball.now().position, picture.tuning.rival_near) > 0;
}

}  // namespace

std::optional<Move> freeBall(const Picture& picture, int robot, Memory& memory) {
  const Vec2 rel = picture.ballFrom(robot);
  // Where robots cannot shove each other, one beside the ball could only drive it back.
  const bool behind = picture.pitch.shoves || rel.x > 0.5 * norm(rel);
  if (!behind || !disputesFreeBall(picture) || !contested(picture)) return std::nullopt;
  if (memory.spin.locked <= 0.0 && isStandOff(picture, rel, shotOf(picture, robot, memory.shot).aim))
    return std::nullopt;
  return Move{.twist = pressOn(picture, robot, memory.press),
              .reason = "a free ball is disputed",
              .ball = firstTouch(picture)};
}

}  // namespace fulbito::libero::striker
