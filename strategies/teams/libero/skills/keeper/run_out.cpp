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
  constexpr double kStrip = 0.16;     // [m] greatest distance of the ball from the wall
  constexpr double kNearest = 0.15;   // [m] least |y| of the ball
  constexpr double kFarthest = 0.45;  // [m] greatest |y| of the ball
  constexpr double kComing = 0.3;     // [m/s] least speed of the ball toward the goal's middle
  constexpr double kRow = 0.03;       // [m] from the keeper's line to a ball that touches its front
  constexpr double kRoom = 0.06;      // [m] between the centres of keeper and ball when they touch
  constexpr double kLeast = 0.10;     // [m] least |y| of the meeting; the keeper waits for balls farther in
  constexpr double kOffLine = 0.05;   // [m] greatest distance of the keeper from its line
  constexpr double kTurned = 0.5;     // [rad] greatest angle between keeper and line
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const double line = keeperLine(pitch);
  const BallState& ball = picture.ball.now();
  const double out = ball.position.y >= 0.0 ? 1.0 : -1.0;
  const double y = ball.position.y * out, across = -ball.velocity.y * out;
  if (ball.position.x > -pitch.half_length + kStrip || y < kNearest || y > kFarthest || across < kComing ||
      !opponentDribblesAtGoal(picture.seen, picture.ball.now()))
    return std::nullopt;
  const double before = std::max(0.0, ball.position.x - (line + kRow));
  const double meet = y - across * before / -ball.velocity.x - kRoom;
  const double own = self.pose.position.y * out;
  if (meet < kLeast || own > y - kRoom / 2) return std::nullopt;
  if (std::abs(self.pose.position.x - line) > kOffLine ||
      std::abs(foldedError(math::kPi / 2, self.pose.heading)) > kTurned)
    return std::nullopt;
  const bool there = own > meet - 0.01;
  const Twist twist = there ? slideTo(picture, self, line, out * meet)
                            : alongLine(picture.pitch, self, line, out * pitch.speed);
  return Move{.twist = twist,
              .reason = "an opponent brings the ball past the near post",
              .place = Vec2{line, out * meet}};
}

}  // namespace fulbito::libero::keeper
