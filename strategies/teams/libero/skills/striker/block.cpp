#include "strategies/teams/libero/defence/dribble.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {

std::optional<Move> block(const Picture& picture, int robot, Memory& /*memory*/) {
  if (!canBlockDribble(picture, picture.own(robot))) return std::nullopt;
  return blockDribble(picture, picture.own(robot));
}

}  // namespace fulbito::libero::striker
