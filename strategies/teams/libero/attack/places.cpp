#include "strategies/teams/libero/attack/places.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/skills/area_projection.hpp"

namespace fulbito::libero {
namespace {

constexpr double kOffArea = 0.07;  // [m] of a place from our area

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

/// `place` moved off the striker's ball and out of the areas.
Vec2 apart(const Picture& picture, Vec2 place) {
  constexpr double kRoom = 0.22;  // [m] kept from the striker's ball
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  if (squaredNorm(place - ball) < kRoom * kRoom) {
    place = insideWalls(pitch.field, ball + unitOr(place - ball, {-1.0, 0.0}) * kRoom, 0.06);
  }
  place = outsideArea(pitch.field, place, true, kOffArea);
  return isInArea(pitch.field, ball, false, 0.1) ? outsideArea(pitch.field, place, false, 0.08) : place;
}

Twist twistTo(const Picture& picture, int robot, Vec2 place) {
  const RobotState& self = picture.own(robot);
  const double d = distance(self.pose.position, place);
  const Vec2 ball = picture.ball.now().position;
  if (d < 0.03) return restAt(picture.pitch, self, place, math::angleOf(ball - self.pose.position), 0.04);
  const double speed = std::min(picture.pitch.speed, stoppingSpeed(0.7 * picture.pitch.braking, d));
  return alongHeading(picture.pitch, self, headingRound(picture, robot, place), speed);
}

}  // namespace

Vec2 ballAhead(const Picture& picture) { return picture.ball.at(0.15); }

double farSide(Vec2 ball, Vec2 robot) {
  constexpr double kMiddle = 0.001;  // [m]
  if (std::abs(ball.y) < kMiddle) return robot.y < 0.0 ? -1.0 : 1.0;
  return ball.y > 0.0 ? -1.0 : 1.0;
}

Vec2 coverPlace(const Picture& picture) {
  constexpr double kAside = 0.6;  // share of the way from the goal's middle to the post
  const Pitch& pitch = picture.pitch;
  const double side = picture.ball.now().position.y >= 0.0 ? 1.0 : -1.0;
  const Vec2 front{-pitch.half_length + pitch.field.goal_area_depth, side * pitch.goal_half * kAside};
  return outsideArea(pitch.field, front, true, kOffArea);
}

Move travel(const Picture& picture, int robot, Vec2 place, const char* reason) {
  return {.twist = twistTo(picture, robot, place), .reason = reason, .place = place, .travels = true};
}

Move standBy(const Picture& picture, int robot, Vec2 place, const char* reason) {
  return travel(picture, robot, apart(picture, place), reason);
}

}  // namespace fulbito::libero
