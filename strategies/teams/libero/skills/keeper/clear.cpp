#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/motion/approach.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

constexpr double kStuck = 2.0;  // [s] after which the keeper clears even if opponents are near

/// Whether the keeper reaches a ball near the goal before any opponent. For a fast ball it keeps its line,
/// since a keeper that turns to clear opens a gap. Fast balls along the end wall are an exception.
bool comesFirst(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  constexpr double kSlow = 0.6;  // [m/s]
  const Vec2 ball = picture.ball.at(0.1);
  if (ball.x > -pitch.half_length + 0.24 || std::abs(ball.y) > 0.36) return false;
  const BallState& now = picture.ball.now();
  if (now.position.x > -pitch.half_length + 0.06 && squaredNorm(now.velocity) > kSlow * kSlow) return false;
  const double mine = timeToReach(pitch.pace, self, ball);
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.opponentPresent(i) && timeToReach(pitch.pace, picture.opponent(i), ball) < mine) return false;
  }
  return true;
}

/// Whether the keeper leaves its goal along the end wall to reach a ball there. Far from the post the wall is
/// behind the keeper, and no ball passes it. At the post an opponent would arrive at full speed, push beside
/// the keeper's centre and turn it, and the ball would go in.
bool meetsAlongWall(const Picture& picture, const RobotState& self) {
  constexpr double kStrip = 0.06;     // [m] greatest distance of the ball from the wall
  constexpr double kOwnStrip = 0.09;  // [m] greatest distance of the keeper from the wall
  constexpr double kFarthest = 0.55;  // [m] greatest |y| of the ball
  constexpr double kFastest = 1.0;    // [m/s] toward the goal; a faster ball arrives before the keeper
  constexpr double kBetween = 0.03;   // [m] by which the keeper must be nearer to the goal's middle
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double out = ball.position.y >= 0.0 ? 1.0 : -1.0;
  const double y = ball.position.y * out;
  if (ball.position.x > -pitch.half_length + kStrip || y < pitch.goal_half - 0.02 || y > kFarthest)
    return false;
  if (ball.velocity.y * out < -kFastest) return false;
  return self.pose.position.x < -pitch.half_length + kOwnStrip && self.pose.position.y * out < y - kBetween;
}

/// Pushes a near ball out to the side, away from the goal; empty if the keeper is not on the goal's side of
/// the ball.
std::optional<Twist> pushAside(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.at(0.05);
  const Vec2 rel = ball - self.pose.position;
  // A keeper that was pushed into the mouth with the ball in front has no wall behind it. It pushes out a
  // ball that is stuck there, but only after a while, because its turn may let the ball in.
  const bool in_mouth = picture.stuck > 2 * kStuck &&
                        std::abs(ball.y) < pitch.goal_half - pitch.ball_radius &&
                        self.pose.position.x < ball.x - 0.03;
  const bool at_wall = !in_mouth && ball.x < -pitch.half_length + pitch.ball_radius + 0.04;
  const double out = ball.y >= 0.0 ? 1.0 : -1.0;
  const bool beside = rel.x < 0.03 && std::abs(rel.x) < 0.05 && rel.y * out > 0.04;
  if (at_wall || beside) {
    if (rel.y * out < 0.02) return std::nullopt;
    return passThrough(pitch, self, {std::max(ball.x, keeperLine(pitch)), ball.y + 0.1 * out});
  }
  if (rel.x < 0.02) return std::nullopt;
  const Vec2 way = unitOr(rel, {1.0, 0.0}) + Vec2{0.3, out * 0.4};
  int side = 0;
  const double heading =
      approachHeading(pitch, self.pose.position, ball, math::angleOf(way), roundRadius(pitch), side);
  return alongHeading(pitch, self, heading, pitch.speed);
}

}  // namespace

std::optional<Move> clear(const Picture& picture, int robot, Memory& /*memory*/) {
  const RobotState& self = picture.own(robot);
  const Vec2 ball = picture.ball.now().position;
  const bool stuck = picture.stuck > kStuck && isInArea(picture.pitch.field, ball, true, 0.05);
  const bool first = !stuck && comesFirst(picture, self);
  if (!stuck && !first && !meetsAlongWall(picture, self)) return std::nullopt;
  if (shotComes(picture)) return std::nullopt;
  const auto twist = pushAside(picture, self);
  if (!twist) return std::nullopt;
  return Move{.twist = *twist,
              .reason = stuck   ? "the ball is stuck in our area"
                        : first ? "the keeper is first at the ball"
                                : "the ball is at the end wall",
              .ball = ball};
}

}  // namespace fulbito::libero::keeper
