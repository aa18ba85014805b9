#include <cmath>

#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/attack/places.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::support {
namespace {

/// The place [m] in front of our area from which a robot covers the goal that the keeper may leave: on the
/// side of the ball, within a keeper's leash of the goal's centre.
Vec2 coverPlace(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const double side = picture.ball.now().position.y >= 0.0 ? 1.0 : -1.0;
  const Vec2 front{-pitch.half_length + pitch.field.goal_area_depth, side * pitch.goal_half / 2};
  return outsideArea(pitch.field, front, true, pitch.touch);
}

}  // namespace

/// The keeper leaves its goal along the end wall, for balls beside the area.
std::optional<Move> cover(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  if (picture.keeper < 0 || picture.rank[static_cast<std::size_t>(robot)] > 0) return std::nullopt;
  // Its side is at the post, so it is on its way out, and the way to the goal's front takes a while.
  if (std::abs(picture.own(picture.keeper).pose.position.y) < pitch.goal_half - pitch.robot_half)
    return std::nullopt;
  if (ballAhead(picture).x > -pitch.half_length + pitch.field.goal_area_depth) return std::nullopt;
  return travel(picture, robot, coverPlace(picture), "the keeper is out of its goal");
}

}  // namespace fulbito::libero::support
