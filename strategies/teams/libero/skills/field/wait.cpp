#include <algorithm>
#include <iterator>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::field {

/// The first stands in front of the area and covers the goal, which the keeper may leave. The striker stands
/// beside the area, ready for balls that come out.
std::optional<Move> wait(const Picture& picture, int robot, Memory& /*memory*/) {
  if (!picture.keepers_ball) return std::nullopt;
  const double back = -picture.pitch.half_length;
  const double side = picture.ball.now().position.y >= 0.0 ? 1.0 : -1.0;
  if (robot == picture.striker)
    return travel(picture, robot, {back + 0.5, side * 0.45}, "the ball is the keeper's");
  const Vec2 places[] = {coverPlace(picture), {back + 0.9, -side * 0.45}, {back + 0.8, 0.0}};
  return travel(picture, robot, places[std::min(picture.rank[static_cast<std::size_t>(robot)], 2)],
                "the ball is the keeper's");
}

}  // namespace fulbito::libero::field
