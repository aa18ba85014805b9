#include "strategies/teams/libero/defence/dribble.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "strategies/skills/dribbling.hpp"
#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {
namespace {

/// Whether an opponent is near a ball in the own half with the ball between it and the own goal.
bool threatened(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  // The robot races for a ball at a wall.
  if (ball.x > pitch.bodies || squaredNorm(insideWalls(pitch.field, ball, pitch.front) - ball) > 1e-9)
    return false;
  const double near = picture.tuning.rival_far;
  const Vec2 goal = pitch.ownGoal() - ball;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (!picture.opponentPresent(i)) continue;
    const Vec2 rel = ball - picture.opponent(i).pose.position;
    if (squaredNorm(rel) < near * near && dot(rel, goal) > 0.0) return true;
  }
  return false;
}

/// Whether two opponents are at the ball: they push past a robot that blocks only one of them.
bool crowded(const Picture& picture) {
  return picture.opponentsNear(picture.ball.now().position, picture.tuning.rival_far) > 1;
}

/// Unit vector of the ball's course: its velocity if an opponent pushes it, otherwise toward the own goal.
Vec2 wayOf(const Picture& picture, bool pushed) {
  const BallState& ball = picture.ball.now();
  return unitOr(pushed ? ball.velocity : picture.pitch.ownGoal() - ball.position, {-1.0, 0.0});
}

}  // namespace

bool canBlockDribble(const Picture& picture, const RobotState& robot) {
  const bool pushed = opponentDribblesAtGoal(picture.seen, picture.ball.now());
  if (!pushed && (picture.pitch.isLarge() || !threatened(picture))) return false;
  if (!picture.pitch.isLarge() && crowded(picture)) return false;
  const Vec2 rel = intoFrame(wayOf(picture, pushed), robot.pose.position - picture.ball.now().position);
  return rel.x > picture.pitch.ball_radius && std::abs(rel.y) < rel.x / 2 + picture.pitch.robot_corner;
}

Move blockDribble(const Picture& picture, const RobotState& robot) {
  const BallState& ball = picture.ball.now();
  const bool pushed = opponentDribblesAtGoal(picture.seen, picture.ball.now());
  const Vec2 way = wayOf(picture, pushed);
  const Vec2 goal = intoFrame(way, picture.pitch.ownGoal() - ball.position);
  const double lead = std::min(picture.tuning.rival_far, distance(robot.pose.position, ball.position) / 2);
  const double inner = pushed ? std::copysign(picture.pitch.ball_radius, goal.y) : 0.0;
  const Vec2 to = ball.position + outOfFrame(way, {lead, inner});
  return {
      .twist = passThrough(picture.pitch, robot, to),
      .reason = pushed ? "an opponent dribbles at our goal" : "an opponent is about to dribble at our goal",
      .place = to};
}

}  // namespace fulbito::libero
