#include "strategies/teams/libero/defence/dribble.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

std::optional<Move> block(const Picture& picture, int robot, Memory& /*memory*/) {
  const RobotState& self = picture.own(robot);
  const Pitch& pitch = picture.pitch;
  // Nearer to our goal line, the robot would be pushed into the area.
  if (self.pose.position.x <= -pitch.half_length + pitch.area_front + 2 * pitch.around ||
      !canBlockDribble(picture, self))
    return std::nullopt;
  return blockDribble(picture, self);
}

}  // namespace fulbito::libero::support
