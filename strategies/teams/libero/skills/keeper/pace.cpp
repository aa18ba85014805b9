#include <cmath>

#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

/// Whether a shot from where the ball is takes longer to the keeper than the keeper to either post, from
/// wherever it paces.
bool hasTime(const Picture& picture, int robot, double reach) {
  const Pitch& pitch = picture.pitch;
  const double time = timeAlong(pitch.pace, pitch.goal_half + reach, -pitch.tuning.lies);
  return norm(picture.ballFrom(robot)) > pitch.tuning.strike_speed * time;
}

/// The speed [m/s] along the line of a keeper that moves to and fro, up to `reach` [m] from a place `way` [m]
/// ahead of it. It goes on the way that it moves, so it needs no memory.
double pacing(const Pitch& pitch, double way, double speed, double reach) {
  const double gained = pitch.acceleration * pitch.tick;  // in a tick
  const double going = std::copysign(1.0, 2.0 * std::abs(speed) > gained ? speed : way);
  const bool turns = reach + going * way < speed * speed / (2.0 * pitch.plannedBraking());
  return (turns ? -going : going) * pitch.tuning.lies;
}

}  // namespace

/// A robot that stops faster than it speeds up loses little if the ball comes from where it moves, and gains
/// its speed on the other side. So one that waits is sooner at its place if it does not stand still.
std::optional<Move> pace(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const double reach = pitch.ball_radius, line = keeperLine(pitch);
  if (!hasTime(picture, robot, reach) || std::abs(line - self.pose.position.x) > pitch.front ||
      shotAtKeeper(picture))
    return std::nullopt;
  const double y = readyPlace(picture), way = y - self.pose.position.y;
  if (std::abs(way) > reach) return std::nullopt;
  return Move{.twist = alongLine(pitch, self, line, pacing(pitch, way, self.velocity.y, reach)),
              .reason = "on its toes for both posts",
              .place = Vec2{line, y}};
}

}  // namespace fulbito::libero::keeper
