#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether an opponent is near enough to take the ball from a robot that turns away to aim. Otherwise the
/// robot aims, since a straight push sends the ball into the opponents' corner, from where it returns along
/// the wall.
bool contested(const Picture& picture) {
  return picture.seen.since_restart < picture.pitch.turn_time ||
         picture.opponentsNear(picture.ball.now().position, picture.tuning.rival_near) > 0;
}

/// Whether an opponent near the ball faces it, and does not leave it. Keepers that take a free ball often go
/// back at once.
bool isMet(const Picture& picture) {
  const Tuning& tuning = picture.tuning;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (!picture.opponentPresent(i)) continue;
    const RobotState& other = picture.opponent(i);
    const Vec2 way = picture.ball.now().position - other.pose.position;
    const double far = norm(way);
    if (far < tuning.rival_near && dot(other.velocity, way) > -tuning.lies * far &&
        std::abs(dot(math::unit(other.pose.heading), way)) > math::cos(tuning.turn_in) * far)
      return true;
  }
  return false;
}

}  // namespace

std::optional<Move> freeBall(const Picture& picture, int robot, Memory& memory) {
  const Vec2 rel = picture.ballFrom(robot);
  // A robot ahead of the ball could only drive it back. In our half, so does one beside it.
  const bool behind = rel.x > (picture.ball.now().position.x < 0.0 ? 0.5 * norm(rel) : 0.0);
  if (!behind || !picture.disputesFreeBall() || !contested(picture)) return std::nullopt;
  if (memory.spin.locked <= 0.0 &&
      (touchesFreeBall(picture, rel) || isStandOff(picture, rel, shotOf(picture, robot, memory.shot).aim)))
    return std::nullopt;
  // A ball that nobody meets would run away from a robot that drives at it.
  if (keeperTookFreeBall(picture) && !isMet(picture))
    return Move{.twist = holdBall(picture, robot), .reason = "nobody meets it", .ball = firstTouch(picture)};
  return Move{.twist = pressOn(picture, robot, memory.press),
              .reason = "a free ball is disputed",
              .ball = firstTouch(picture)};
}

}  // namespace fulbito::libero::striker
