#include <cmath>

#include "strategies/skills/wall_play.hpp"
#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

void end(const Picture& picture, Memory::Spin& spin) {
  spin.left = 0.0;
  spin.locked = picture.tuning.spin_time;
}

Move turning(const Picture& picture, Memory::Spin& spin, const char* reason) {
  spin.left -= picture.seen.dt;
  if (spin.left <= 0.0) end(picture, spin);
  return {.twist = {0.0, spin.sense * picture.tuning.spin_rate}, .reason = reason};
}

Move begin(const Picture& picture, int robot, Memory& memory, Vec2 wanted, const char* reason) {
  memory.press.jammed = 0.0;
  memory.spin.left = picture.tuning.spin_time;
  memory.spin.sense = spinSense(picture.own(robot).pose.position, picture.ball.now().position, wanted);
  return turning(picture, memory.spin, reason);
}

/// Across the field: past their goal, where a mate waits, and away from ours.
Vec2 across(Vec2 ball) { return {0.0, std::copysign(1.0, -ball.x * ball.y)}; }

/// Whether the ball is beside a robot that would take long to drive round it.
bool beside(const Picture& picture, Vec2 rel, const Aim& aim) {
  return norm(rel) < picture.pitch.touch && std::abs(dot(unitOr(rel, {}), aim.direction)) < 0.5;
}

}  // namespace

/// A robot whose ball has left has thrown it, and may be the first to reach it again.
std::optional<Move> spinOn(const Picture& picture, int robot, Memory& memory) {
  if (memory.spin.left <= 0.0) return std::nullopt;
  if (norm(picture.ballFrom(robot)) > picture.pitch.around) {
    end(picture, memory.spin);
    return std::nullopt;
  }
  return turning(picture, memory.spin, "the spin is not over");
}

/// Where robots can shove, a spin gives a duel up, since the opponent pushes on. So does one at a wall, where
/// the ball has no room to leave.
std::optional<Move> spin(const Picture& picture, int robot, Memory& memory) {
  if (picture.pitch.shoves || memory.spin.locked > 0.0) return std::nullopt;
  const Tuning& tuning = picture.tuning;
  const Vec2 rel = picture.ballFrom(robot), ball = picture.ball.now().position;
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  if (isStandOff(picture, rel, aim)) return begin(picture, robot, memory, across(ball), "nobody gives way");
  if (touchesFreeBall(picture, rel))
    return begin(picture, robot, memory, across(ball), "a free ball is thrown across");
  if (aim.wall || ball.x <= tuning.spin_from) return std::nullopt;
  if (beside(picture, rel, aim)) return begin(picture, robot, memory, aim.direction, "the ball is beside it");
  if (memory.press.jammed > tuning.jam_time)
    return begin(picture, robot, memory, aim.direction, "the ball is jammed");
  return std::nullopt;
}

}  // namespace fulbito::libero::striker
