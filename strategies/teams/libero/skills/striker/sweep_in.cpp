#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::striker {
namespace {

/// Whether the ball runs along the opponents' goal line through the mouth, in front of the robot. Then the
/// robot turns it in while it pushes. A robot that drives round it would arrive after the ball has passed the
/// other post.
bool sweepsIn(const Picture& picture, Vec2 rel) {
  constexpr double kBefore = 0.12;  // [m] before the line
  constexpr double kPast = 0.03;    // [m] past a post
  constexpr double kNear = 0.085;   // [m]
  constexpr double kBehind = 0.01;  // [m] by which the robot may be nearer to the line
  constexpr double kRolls = 0.15;   // [m/s]
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  if (ball.position.x < pitch.half_length - kBefore || std::abs(ball.position.y) > pitch.goal_half + kPast)
    return false;
  return squaredNorm(rel) < kNear * kNear && rel.x > -kBehind && std::abs(ball.velocity.y) > kRolls &&
         rel.y * ball.velocity.y > 0.0;
}

}  // namespace

std::optional<Move> sweepIn(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kInto = 0.4;  // into the goal, per way along it; more would lose the ball sideways
  if (!sweepsIn(picture, picture.ballFrom(robot))) return std::nullopt;
  const BallState& ball = picture.ball.now();
  const double across = std::copysign(1.0, ball.velocity.y);
  return Move{.twist = alongHeading(picture.own(robot), math::angleOf({kInto, across}), picture.pitch.speed),
              .reason = "the ball runs through the mouth",
              .ball = ball.position};
}

}  // namespace fulbito::libero::striker
