#include "strategies/teams/libero/motion/room.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

std::optional<Move> roundKeeper(const Picture& picture, int robot, Memory& /*memory*/) {
  const Vec2 ball = picture.ball.now().position;
  const auto twist = libero::roundKeeper(picture, robot, ball);
  if (!twist) return std::nullopt;
  return Move{.twist = *twist, .reason = "their keeper is in the way", .ball = ball};
}

}  // namespace fulbito::libero::striker
