#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

/// Whether the ball lies or rolls along the own end wall, beside the goal or at the edge of its mouth.
bool alongEndWall(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  return ball.x < -pitch.half_length + 0.08 && std::abs(ball.y) > 0.10 && std::abs(ball.y) < 0.5;
}

}  // namespace

/// Closes the near post with a face that deflects the ball into the field. The keeper stands within the
/// mouth, so that a ball pushed along the wall hits the middle of its face. A hit beside the middle would
/// turn the keeper, and the ball would pass behind it.
std::optional<Move> guardPost(const Picture& picture, int robot, Memory& /*memory*/) {
  constexpr double kInFront = 0.03;  // [m] a keeper nearer to the line than the ball can still save a shot
  constexpr double kLean = 0.15;     // [rad]
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  if (!alongEndWall(picture) || (picture.ballFrom(robot).x > kInFront && shotComes(picture)))
    return std::nullopt;
  const Vec2 ball = picture.ball.now().position;
  const double side = ball.y > 0.0 ? 1.0 : -1.0;
  const Vec2 post{-pitch.half_length + 0.025,
                  side * std::min(pitch.goal_half - 0.045, std::abs(ball.y) - 0.055)};
  const Vec2 way = post - self.pose.position;
  Move move{.reason = "the ball is at the end wall", .place = post};
  // A keeper that was pushed into the goal must leave it first.
  if (std::abs(way.y) < 0.02 && way.x < 0.04) {
    move.twist = turnTo(pitch, self, side * (math::kPi / 2 - kLean));
    move.twist.linear = std::clamp(4.0 * dot(way, math::unit(self.pose.heading)), -0.2, 0.2);
  } else {
    move.twist = slideTo(picture, self, post.x, post.y);
  }
  return move;
}

}  // namespace fulbito::libero::keeper
