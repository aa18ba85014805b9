#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::field {
namespace {

/// Whether the robot drives with the ball right in front of it.
bool hasItInFront(const Pitch& pitch, const RobotState& self, Vec2 ball) {
  const double speed = norm(self.velocity);
  if (speed < pitch.tuning.lies) return false;
  const Vec2 rel = intoFrame(self.velocity / speed, ball - self.pose.position);
  return rel.x > pitch.ball_radius && rel.x < pitch.around && std::abs(rel.y) < pitch.robot_half;
}

/// The point [m] of their goal's mouth next to where the ball rolls; empty if that is not ahead. From our
/// half no ball gets through, and the robot would be far forward once it comes back. A ball that would miss
/// the mouth is only pushed on if an opponent could take it: otherwise there is time to mend its course.
std::optional<Vec2> mouthAhead(const Picture& picture, const BallState& ball) {
  const Pitch& pitch = picture.pitch;
  if (ball.position.x < 0.0 || ball.velocity.x < pitch.tuning.lies) return std::nullopt;
  const double left = pitch.half_length - ball.position.x;
  const double most = pitch.goal_half - pitch.ball_radius - pitch.tuning.clearance;
  const double y = ball.position.y + ball.velocity.y / ball.velocity.x * left;
  if (std::abs(y) > most && picture.opponentsNear(ball.position, picture.tuning.rival_far) == 0)
    return std::nullopt;
  const Vec2 target{pitch.half_length, std::clamp(y, -most, most)};
  const Vec2 way = unitOr(target - ball.position, {1.0, 0.0});
  if (dot(way, ball.velocity) < math::cos(pitch.tuning.turn_in) * norm(ball.velocity)) return std::nullopt;
  return target;
}

}  // namespace

/// A struck ball slides, and has lost nearly a third of its speed once it rolls. A robot that stays behind it
/// pushes it on, ever faster, and a keeper has less time.
std::optional<Move> followThrough(const Picture& picture, int robot, Memory& memory) {
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const BallState& ball = picture.ball.now();
  // The taker of a penalty has aimed, and a push may bend the ball's way.
  if (memory.spin.left > 0.0 || picture.isPenalty() || !hasItInFront(pitch, self, ball.position))
    return std::nullopt;
  const auto target = mouthAhead(picture, ball);
  if (!target) return std::nullopt;
  Move move{.twist = passThrough(pitch, self, *target),
            .reason = "a ball that rolls at their goal is pushed on",
            .ball = ball.position};
  move.target = target;
  return move;
}

}  // namespace fulbito::libero::field
