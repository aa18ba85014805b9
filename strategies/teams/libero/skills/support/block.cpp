#include "strategies/teams/libero/defence/dribble.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

std::optional<Move> block(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kDeep = 0.45;  // [m] from our goal line; nearer, the robot would be pushed into the area
  const RobotState& self = picture.own(robot);
  if (self.pose.position.x <= -picture.pitch.half_length + kDeep || !canBlockDribble(picture, self))
    return std::nullopt;
  return blockDribble(picture, self);
}

}  // namespace fulbito::libero::support
