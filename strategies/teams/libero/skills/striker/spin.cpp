#include "strategies/skills/wall_play.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

Move turning(const Picture& picture, Memory::Spin& spin, const char* reason) {
  spin.left -= picture.seen.dt;
  if (spin.left <= 0.0) spin.locked = picture.tuning.spin_time;
  return {.twist = {0.0, spin.sense * picture.tuning.spin_rate}, .reason = reason};
}

/// Whether the ball lies at a wall beside the robot or behind it.
bool pinned(const Picture& picture, Vec2 rel, const Aim& aim) {
  return aim.wall && norm(rel) < picture.pitch.touch + picture.tuning.clearance &&
         norm(picture.ball.now().velocity) < picture.tuning.lies && dot(unitOr(rel, {}), aim.direction) < 0.5;
}

}  // namespace

std::optional<Move> spinOn(const Picture& picture, int /*robot*/, Memory& memory) {
  if (memory.spin.left <= 0.0) return std::nullopt;
  return turning(picture, memory.spin, "the spin is not over");
}

std::optional<Move> spin(const Picture& picture, int robot, Memory& memory) {
  const Tuning& tuning = picture.tuning;
  if (picture.ball.now().position.x <= tuning.spin_from) return std::nullopt;
  const Vec2 rel = picture.ballFrom(robot);
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  const bool jammed = memory.press.jammed > tuning.jam_time;
  if (memory.spin.locked > 0.0 || (!jammed && !pinned(picture, rel, aim))) return std::nullopt;
  memory.press.jammed = 0.0;
  memory.spin.left = tuning.spin_time;
  memory.spin.sense = spinSense(picture.own(robot).pose.position, picture.ball.now().position, aim.direction);
  return turning(picture, memory.spin, jammed ? "the ball is jammed" : "the ball is pinned at a wall");
}

}  // namespace fulbito::libero::striker
