#include <algorithm>
#include <iterator>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::field {

/// The first stands in front of the area and covers the goal, which the keeper may leave. The striker stands
/// beside the area, ready for balls that come out.
std::optional<Move> wait(const Picture& picture, int robot, Memory& /*memory*/) {
  if (!picture.keepers_ball) return std::nullopt;
  const Pitch& pitch = picture.pitch;
  const double front = -pitch.half_length + pitch.area_front, far = picture.tuning.rival_far;
  const double wide = pitch.area_half + pitch.bodies;
  const double side = picture.ball.now().position.y >= 0.0 ? 1.0 : -1.0;
  if (robot == picture.striker)
    return travel(picture, robot, {front + far, side * wide}, "the ball is the keeper's");
  const Vec2 places[] = {coverPlace(picture), {front + 2 * far, -side * wide}, {front + 2 * far, 0.0}};
  return travel(picture, robot, places[std::min(picture.rank[static_cast<std::size_t>(robot)], 2)],
                "the ball is the keeper's");
}

}  // namespace fulbito::libero::field
