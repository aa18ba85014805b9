#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

/// The robot that arrives first gets the ball. Turning parallel to the wall first would cost 0.1 s.
std::optional<Move> race(const Picture& picture, int robot, Memory& memory) {
  constexpr double kLies = 0.3;     // [m/s]
  constexpr double kRival = 0.3;    // [m] an opponent nearer than this is at the ball in about 0.2 s
  constexpr double kBehind = 0.02;  // [m] a push at the centre would press the ball into the wall
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  if (!isFoughtFor(picture, picture.ballFrom(robot), aim, kLies, kRival)) return std::nullopt;
  const Vec2 place = aim.contact - aim.direction * kBehind;
  return Move{.twist = passThrough(picture.own(robot), place, picture.pitch.speed),
              .reason = "an opponent races for it at a wall",
              .ball = aim.contact};
}

}  // namespace fulbito::libero::striker
