#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

/// The robot that arrives first gets the ball. Turning parallel to the wall first would cost 0.1 s.
std::optional<Move> race(const Picture& picture, int robot, Memory& memory) {
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  if (!isFoughtFor(picture, picture.ballFrom(robot), aim, picture.tuning.rolls, picture.tuning.rival_far))
    return std::nullopt;
  // A push at the centre would press the ball into the wall.
  const Vec2 place = aim.contact - aim.direction * picture.pitch.ball_radius;
  return Move{.twist = passThrough(picture.pitch, picture.own(robot), place),
              .reason = "an opponent races for it at a wall",
              .ball = aim.contact};
}

}  // namespace fulbito::libero::striker
