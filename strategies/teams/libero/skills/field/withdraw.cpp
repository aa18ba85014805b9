#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::field {

/// The striker waits between ball and our goal, and the others beside it, toward the far side.
std::optional<Move> withdraw(const Picture& picture, int robot, Memory& /*memory*/) {
  if (!picture.stall_given_up) return std::nullopt;
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  Vec2 place = ball + unitOr(pitch.ownGoal() - ball, {-1.0, 0.0}) * (2 * picture.tuning.behind);
  const int beside = robot == picture.striker ? 0 : 1 + picture.rank[static_cast<std::size_t>(robot)];
  place.y -= std::copysign(4 * beside * pitch.bodies, ball.y);
  place = insideWalls(pitch.field, place, pitch.robot_corner + pitch.tuning.clearance);
  return travel(picture, robot, place, "nobody wins this ball");
}

}  // namespace fulbito::libero::field
