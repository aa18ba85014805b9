#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/motion/approach.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

/// Whether the keeper reaches a ball near the goal before any opponent. One that speeds up slowly must have
/// the time to turn back to its line, too. For a fast ball it keeps its line, since a keeper that turns to
/// clear opens a gap. Fast balls along the end wall are an exception.
bool comesFirst(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.sample(2);
  const double deep = pitch.area_front + pitch.robot_half, wide = pitch.area_half + pitch.tuning.clearance;
  if (ball.x > -pitch.half_length + deep || std::abs(ball.y) > wide) return false;
  const BallState& now = picture.ball.now();
  if (now.position.x > -pitch.half_length + pitch.front && norm(now.velocity) > picture.tuning.touch_speed)
    return false;
  const double needed = timeToReach(pitch.pace, self, ball) + (pitch.shoves ? 0.0 : pitch.turn_time);
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.opponentPresent(i) && timeToReach(pitch.pace, picture.opponent(i), ball) < needed)
      return false;
  }
  return true;
}

/// How far [m] beside the goal's middle a keeper that sets off now meets a ball at the end wall: where it is,
/// or where it has come to along the wall once keeper and ball have closed the gap.
double meetingPlace(const Pitch& pitch, const RobotState& self, const BallState& ball, double out) {
  const double y = ball.position.y * out, coming = std::max(0.0, -ball.velocity.y * out);
  const double gap = std::max(0.0, y - self.pose.position.y * out - pitch.front);
  const double closing = std::max(0.0, coming + self.velocity.y * out);
  const double time = (stoppingSpeed(pitch.acceleration, gap, closing) - closing) / pitch.acceleration;
  return y - coming * time;
}

/// Whether the keeper leaves its goal along the end wall to reach a ball there, as far as the area's depth
/// beside the area, and stays at a ball that it has met. Far from the post the wall is behind the keeper, and
/// no ball passes it. At the post an opponent would arrive at full speed, push beside the keeper's centre and
/// turn it, and the ball would go in. The longer wall of a large match lets opponents come at full speed, so
/// that the keeper sets off sooner.
bool meetsAlongWall(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double out = ball.position.y >= 0.0 ? 1.0 : -1.0;
  const double y = ball.position.y * out;
  if (ball.position.x > -pitch.half_length + pitch.front || y < pitch.goal_half - pitch.ball_radius)
    return false;
  const bool met = distance(self.pose.position, ball.position) < pitch.touch + pitch.front;
  const double place = pitch.isLarge() ? meetingPlace(pitch, self, ball, out) : y;
  if (!met && place > pitch.area_half + pitch.field.goal_area_depth) return false;
  // A fast ball arrives before the keeper.
  return ball.velocity.y * out > -picture.tuning.pushable && closesEndWall(picture, self);
}

/// Pushes a near ball out to the side, away from the goal; empty if the keeper is not on the goal's side of
/// the ball.
std::optional<Twist> pushAside(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.sample(1);
  const Vec2 rel = ball - self.pose.position;
  // A keeper that was pushed into the mouth with the ball in front has no wall behind it. It pushes out a
  // ball that is stuck there, but only after a while, because its turn may let the ball in.
  const bool in_mouth = picture.stuck > 2 * picture.tuning.patience &&
                        std::abs(ball.y) < pitch.goal_half - pitch.ball_radius && rel.x > pitch.ball_radius;
  const bool at_wall = !in_mouth && ball.x < -pitch.half_length + pitch.front;
  const double out = ball.y >= 0.0 ? 1.0 : -1.0;
  const bool beside =
      rel.x < pitch.ball_radius && rel.x > -pitch.robot_corner && rel.y * out > pitch.robot_half;
  if (at_wall || beside) {
    if (rel.y * out < pitch.ball_radius) return std::nullopt;
    // A face that looks into the field keeps the ball's push from turning the keeper off the wall.
    if (at_wall && norm(rel) < pitch.touch && picture.opponentsNear(ball, pitch.touch + pitch.front) > 0)
      return alongHeading(pitch, self, out * (math::kPi / 2 - pitch.tuning.slant), pitch.speed);
    return passThrough(pitch, self, {std::max(ball.x, keeperLine(pitch)), ball.y + pitch.bodies * out});
  }
  if (rel.x < pitch.ball_radius) return std::nullopt;
  const Vec2 way = unitOr(rel, {1.0, 0.0}) + Vec2{0.0, out * pitch.tuning.slant};
  int side = 0;
  const double heading =
      approachHeading(pitch, self.pose.position, ball, math::angleOf(way), roundRadius(pitch, ball.x), side);
  return alongHeading(pitch, self, heading, pitch.speed);
}

}  // namespace

std::optional<Move> clear(const Picture& picture, int robot, Memory& /*memory*/) {
  const RobotState& self = picture.own(robot);
  const Vec2 ball = picture.ball.now().position;
  const bool stuck = picture.stuck > picture.tuning.patience &&
                     isInArea(picture.pitch.field, ball, true, picture.pitch.robot_corner);
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
