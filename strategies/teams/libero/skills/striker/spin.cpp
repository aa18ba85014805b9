#include "strategies/skills/wall_play.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

Move turning(const Picture& picture, Memory::Spin& spin, const char* reason) {
  constexpr double kYawRate = 28.0;  // [rad/s]
  constexpr double kLock = 0.4;      // [s] until the next spin
  spin.left -= picture.seen.dt;
  if (spin.left <= 0.0) spin.locked = kLock;
  return {.twist = {0.0, spin.sense * kYawRate}, .reason = reason};
}

/// Whether the ball lies at a wall beside the robot or behind it.
bool pinned(const Picture& picture, Vec2 rel, const Aim& aim) {
  constexpr double kNear = 0.085;  // [m]
  constexpr double kLies = 0.2;    // [m/s]
  return aim.wall && squaredNorm(rel) < kNear * kNear &&
         squaredNorm(picture.ball.now().velocity) < kLies * kLies &&
         dot(unitOr(rel, {}), aim.direction) < 0.5;
}

}  // namespace

std::optional<Move> spinOn(const Picture& picture, int /*robot*/, Memory& memory) {
  if (memory.spin.left <= 0.0) return std::nullopt;
  return turning(picture, memory.spin, "the spin is not over");
}

std::optional<Move> spin(const Picture& picture, int robot, Memory& memory) {
  constexpr double kUpfield = 0.5;  // [m]
  constexpr double kJammed = 0.35;  // [s]
  constexpr double kSpins = 0.45;   // [s]
  if (picture.ball.now().position.x <= kUpfield) return std::nullopt;
  const Vec2 rel = picture.ballFrom(robot);
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  const bool jammed = memory.press.jammed > kJammed;
  if (memory.spin.locked > 0.0 || (!jammed && !pinned(picture, rel, aim))) return std::nullopt;
  memory.press.jammed = 0.0;
  memory.spin.left = kSpins;
  memory.spin.sense = spinSense(picture.own(robot).pose.position, picture.ball.now().position, aim.direction);
  return turning(picture, memory.spin, jammed ? "the ball is jammed" : "the ball is pinned at a wall");
}

}  // namespace fulbito::libero::striker
