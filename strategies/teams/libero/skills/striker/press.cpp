#include "strategies/teams/libero/attack/press.hpp"

#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
std::optional<Move> press(const Picture& picture, int robot, Memory& memory) {
  if (!headOn(picture, picture.ballFrom(robot), shotOf(picture, robot, memory.shot).aim)) return std::nullopt;
  return Move{.twist = pressOn(picture, robot, memory.press),
              .reason = "an opponent presses from the other side",
              .ball = firstTouch(picture)};
}

}  // namespace fulbito::libero::striker
