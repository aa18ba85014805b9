#include <algorithm>

#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {

/// The places are on the side away from the ball, and never in the big area.
std::optional<Move> outlet(const Picture& picture, int robot, Memory& /*memory*/) {
  const int rank = picture.rank[static_cast<std::size_t>(robot)];
  if (rank < 2) return std::nullopt;
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = ballAhead(picture);
  const double far_side = ball.y > 0.0 ? -1.0 : 1.0;
  const double back = -pitch.half_length + pitch.field.big_area_depth + pitch.bodies;
  const double gap = picture.tuning.behind + pitch.around;
  // Spins throw the ball across the field, so there the robot waits level with it.
  const double behind = pitch.shoves ? gap : 0.0;
  const Vec2 place = rank == 2 ? Vec2{std::clamp(ball.x - behind, back, pitch.half_length - gap),
                                      far_side * pitch.half_width / 2}
                               : Vec2{std::clamp(ball.x - gap, back, 0.0), far_side * pitch.goal_half};
  return standBy(picture, robot, place, rank == 2 ? "third without the ball" : "fourth without the ball");
}

}  // namespace fulbito::libero::support
