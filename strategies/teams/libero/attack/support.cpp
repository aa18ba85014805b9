#include "strategies/teams/libero/attack/support.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/skills/area_projection.hpp"

namespace fulbito::libero {
namespace {

/// The heading [rad] toward `to`, turned to pass the nearest robot or ball in the way along its tangent.
double headingRound(const Picture& picture, int robot, Vec2 to) {
  const Vec2 from = picture.own(robot).pose.position;
  const double length = norm(to - from);
  const Vec2 way = unitOr(to - from, {1.0, 0.0});
  constexpr double kClear = 0.11;
  double nearest = std::min(length, 0.4);
  Vec2 turned = way;
  const auto look = [&](Vec2 body) {
    const Vec2 rel = intoFrame(way, body - from);
    if (rel.x < 0.0 || rel.x > nearest || std::abs(rel.y) > kClear) return;
    nearest = rel.x;
    const double pass = rel.y > 0.0 ? rel.y - kClear : rel.y + kClear;
    turned = unitOr(outOfFrame(way, {std::max(rel.x, 0.05), pass}), way);
  };
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (i != robot && picture.ownPresent(i)) look(picture.own(i).pose.position);
    if (picture.opponentPresent(i)) look(picture.opponent(i).pose.position);
  }
  look(picture.ball.now().position);
  return math::angleOf(turned);
}

/// The point on the line from the ball to the own goal, outside the area. If the ball is deeper, the point is
/// in front of the area.
Vec2 shadow(const Picture& picture, Vec2 ball) {
  const Pitch& pitch = picture.pitch;
  const Vec2 goal = pitch.ownGoal();
  const double front =
      -pitch.half_length + pitch.field.goal_area_depth + pitch.field.goal_area_arc_depth + 0.09;
  const double x = std::max(front, ball.x - 0.35);
  const double part = std::clamp((x - goal.x) / std::max(0.05, ball.x - goal.x), 0.0, 1.0);
  const double most = ball.x < front + 0.1 ? 0.25 : pitch.half_width - 0.06;
  return {x, std::clamp(ball.y * part, -most, most)};
}

/// A place on the side away from the ball for the third (forward) and the fourth (back) robot without the
/// ball. It is never in the big area.
Vec2 outlet(const Pitch& pitch, Vec2 ball, int rank) {
  const double far_side = ball.y > 0.0 ? -1.0 : 1.0;
  const double back = -pitch.half_length + pitch.field.big_area_depth + 0.15;
  if (rank == 2) return {std::clamp(ball.x - 0.5, back, pitch.half_length - 0.5), far_side * 0.45};
  return {std::clamp(ball.x - 0.55, back, 0.0), far_side * 0.2};
}

/// The side of the field without the ball: +1 or -1. For a ball in the middle, as at a penalty, it is the
/// robot's own side. A fixed side would send some robots across the field.
double farSide(Vec2 ball, Vec2 robot) {
  constexpr double kMiddle = 0.001;  // [m]
  if (std::abs(ball.y) < kMiddle) return robot.y < 0.0 ? -1.0 : 1.0;
  return ball.y > 0.0 ? -1.0 : 1.0;
}

Vec2 wantedPlace(const Picture& picture, int robot, int rank) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.at(0.15);
  if (rank == 1) return shadow(picture, ball);
  if (rank >= 2) return outlet(pitch, ball, rank);
  const double forward = 0.45 - 0.6 * picture.settings.aggression;
  if (ball.x > forward) {
    const double far_side = farSide(ball, picture.own(robot).pose.position);
    return {std::min(ball.x - 0.2, pitch.half_length - 0.35), far_side * 0.18};
  }
  // If opponents crowd the ball in a three-a-side match, nobody else stops a ball that comes out on their
  // side.
  if (!pitch.isLarge() && picture.opponentsNear(ball, 0.25) >= 2) {
    return {std::min(ball.x + 0.3, pitch.half_length - 0.35), std::clamp(ball.y * 0.4, -0.3, 0.3)};
  }
  return shadow(picture, ball);
}

}  // namespace

Vec2 supportPlace(const Picture& picture, int robot, int rank) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  Vec2 place = wantedPlace(picture, robot, rank);
  constexpr double kRoom = 0.22;  // [m] kept from the striker's ball
  if (squaredNorm(place - ball) < kRoom * kRoom) {
    place = insideWalls(pitch.field, ball + unitOr(place - ball, {-1.0, 0.0}) * kRoom, 0.06);
  }
  place = outsideArea(pitch.field, place, true, 0.07);
  return isInArea(pitch.field, ball, false, 0.1) ? outsideArea(pitch.field, place, false, 0.08) : place;
}

Vec2 waitingPlace(const Picture& picture, int rank) {
  const double back = -picture.pitch.half_length;
  const double side = picture.ball.now().position.y >= 0.0 ? 1.0 : -1.0;
  const Vec2 places[] = {
      {back + 0.5, side * 0.45}, {back + 0.5, -side * 0.3}, {back + 0.9, -side * 0.6}, {back + 0.8, 0.0}};
  return places[std::min(rank, 3)];
}

Twist supportTo(const Picture& picture, int robot, Vec2 place) {
  const RobotState& self = picture.own(robot);
  const double d = distance(self.pose.position, place);
  const Vec2 ball = picture.ball.now().position;
  if (d < 0.03) return restAt(picture.pitch, self, place, math::angleOf(ball - self.pose.position), 0.04);
  const double speed = std::min(picture.pitch.speed, stoppingSpeed(0.7 * picture.pitch.braking, d));
  return alongHeading(self, headingRound(picture, robot, place), speed);
}

}  // namespace fulbito::libero
