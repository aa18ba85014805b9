#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/skills/dribbling.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {

/// The target is where the ball arrives in front of the line, reached from the goal's middle. An opponent
/// would push a waiting keeper along its line into the goal.
std::optional<Move> runOut(const Picture& picture, int robot, Memory& /*memory*/) {
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const double line = keeperLine(pitch);
  const BallState& ball = picture.ball.now();
  const double out = ball.position.y >= 0.0 ? 1.0 : -1.0;
  const double y = ball.position.y * out, across = -ball.velocity.y * out;
  if (ball.position.x > -pitch.half_length + pitch.field.goal_area_depth ||
      y < pitch.goal_half - pitch.robot_half || y > pitch.area_half + pitch.bodies ||
      across < pitch.tuning.rolls || !opponentDribblesAtGoal(picture.seen, picture.ball.now()))
    return std::nullopt;
  const double before = std::max(0.0, ball.position.x - (line + pitch.ball_radius + pitch.tuning.clearance));
  const double meet = y - across * before / -ball.velocity.x - pitch.front;
  const double own = self.pose.position.y * out;
  if (meet < pitch.bodies || own > y - pitch.front / 2) return std::nullopt;
  if (std::abs(self.pose.position.x - line) > pitch.robot_corner ||
      std::abs(foldedError(math::kPi / 2, self.pose.heading)) > pitch.tuning.turn_in)
    return std::nullopt;
  const bool there = own > meet - pitch.tuning.clearance;
  const Twist twist = there ? slideTo(picture, self, line, out * meet)
                            : alongLine(picture.pitch, self, line, out * pitch.speed);
  return Move{.twist = twist,
              .reason = "an opponent brings the ball past the near post",
              .place = Vec2{line, out * meet}};
}

}  // namespace fulbito::libero::keeper
