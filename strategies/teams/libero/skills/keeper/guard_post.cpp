#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

/// Closes the near post with a face that deflects the ball into the field. The keeper stands within the
/// mouth, so that a ball pushed along the wall hits the middle of its face. A hit beside the middle would
/// turn the keeper, and the ball would pass behind it. A keeper that is farther out stays there: it would be
/// pushed on faster if it went back.
std::optional<Move> guardPost(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  // A keeper nearer to the line than the ball can still save a shot.
  if (!ballAlongEndWall(picture, pitch.area_half + pitch.field.goal_area_depth) ||
      (picture.ballFrom(robot).x > pitch.ball_radius && shotComes(picture)))
    return std::nullopt;
  const Vec2 ball = picture.ball.now().position;
  const double side = ball.y > 0.0 ? 1.0 : -1.0;
  const double out = closesEndWall(picture, self) ? side * self.pose.position.y : 0.0;
  const double within =
      std::min(pitch.goal_half - pitch.robot_half - pitch.tuning.clearance, std::abs(ball.y) - pitch.front);
  const Vec2 post{-pitch.half_length + pitch.ball_radius, side * std::max(out, within)};
  const Vec2 way = post - self.pose.position;
  Move move{.reason = "the ball is at the end wall", .place = post};
  // A keeper that was pushed into the goal must leave it first.
  if (std::abs(way.y) < pitch.ball_radius && way.x < pitch.robot_half) {
    move.twist = turnTo(pitch, self, side * (math::kPi / 2 - pitch.tuning.slant));
    move.twist.linear = creeping(pitch, dot(way, math::unit(self.pose.heading)));
  } else {
    move.twist = slideTo(picture, self, post.x, post.y);
  }
  return move;
}

}  // namespace fulbito::libero::keeper
