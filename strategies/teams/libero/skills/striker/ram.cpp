#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/attack/wall_duel.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether an opponent near the ball points along the wall more than into it, so that it would come after a
/// robot that backs off.
bool wouldFollow(const Picture& picture, Vec2 along) {
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (!picture.opponentPresent(i)) continue;
    const RobotState& other = picture.opponent(i);
    if (norm(other.pose.position - picture.ball.now().position) < picture.tuning.rival_near &&
        std::abs(dot(math::unit(other.pose.heading), along)) > math::cos(math::kPi / 4))
      return true;
  }
  return false;
}

/// Whether the ball is jammed at a wall of the back half of our half, by opponents that lean into the wall. A
/// robot that is not goal-side would open the way to our goal.
bool isWedged(const Picture& picture, int robot, Memory& memory) {
  if (!picture.pitch.shoves || picture.ball.now().position.x > -picture.pitch.half_length / 2 ||
      picture.ballFrom(robot).x < 0.0 || memory.press.jammed <= picture.tuning.jam_time / 2)
    return false;
  const Aim& aim = shotOf(picture, robot, memory.shot).aim;
  return isPressed(picture, robot, aim) && !wouldFollow(picture, aim.direction);
}

}  // namespace

/// Motors and tyres hold against a push that lasts, but not against a blow. So a robot backs off from a ball
/// that an opponent wedges at the wall, and drives into it again.
std::optional<Move> ram(const Picture& picture, int robot, Memory& memory) {
  Memory::Ram& ram = memory.ram;
  const double run = picture.tuning.jam_time / 2;
  const Vec2 ball = picture.ball.now().position;
  if (ram.left <= 0.0) {
    if (!isWedged(picture, robot, memory)) return std::nullopt;
    const bool front = dot(math::unit(picture.own(robot).pose.heading), picture.ballFrom(robot)) > 0.0;
    ram = {.left = 2.0 * run, .back = front ? -picture.pitch.speed : picture.pitch.speed};
  }
  if (ram.left > run) return Move{.twist = {ram.back, 0.0}, .reason = "takes a run-up", .ball = ball};
  return Move{.twist = passThrough(picture.pitch, picture.own(robot), ball),
              .reason = "an opponent wedges the ball",
              .ball = ball};
}

}  // namespace fulbito::libero::striker
