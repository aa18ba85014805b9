#include "strategies/teams/libero/attack/places.hpp"

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
  const Pitch& pitch = picture.pitch;
  const double clear = pitch.bodies + pitch.tuning.clearance;
  double nearest = std::min(length, 4 * pitch.bodies);
  Vec2 turned = way;
  const auto look = [&](Vec2 body) {
    const Vec2 rel = intoFrame(way, body - from);
    if (rel.x < 0.0 || rel.x > nearest || std::abs(rel.y) > clear) return;
    nearest = rel.x;
    const double pass = rel.y > 0.0 ? rel.y - clear : rel.y + clear;
    turned = unitOr(outOfFrame(way, {std::max(rel.x, pitch.robot_corner), pass}), way);
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
  const Pitch& pitch = picture.pitch;
  const double room = 2 * pitch.bodies;
  const Vec2 ball = picture.ball.now().position;
  if (squaredNorm(place - ball) < room * room) {
    place = insideWalls(pitch.field, ball + unitOr(place - ball, {-1.0, 0.0}) * room,
                        pitch.robot_corner + pitch.tuning.clearance);
  }
  place = outsideArea(pitch.field, place, true, pitch.touch);
  return isInArea(pitch.field, ball, false, pitch.bodies)
             ? outsideArea(pitch.field, place, false, pitch.touch)
             : place;
}

Twist twistTo(const Picture& picture, int robot, Vec2 place, std::optional<double> heading) {
  const RobotState& self = picture.own(robot);
  const double d = distance(self.pose.position, place);
  const Pitch& pitch = picture.pitch;
  if (d < pitch.robot_half) {
    return restAt(pitch, self, place, heading.value_or(math::angleOf(picture.ballFrom(robot))),
                  pitch.robot_half);
  }
  const double speed = std::min(pitch.speed, stoppingSpeed(pitch.plannedBraking(), d));
  return alongHeading(pitch, self, headingRound(picture, robot, place), speed);
}

}  // namespace

Vec2 ballAhead(const Picture& picture) { return picture.ball.at(picture.pitch.turn_time); }

double farSide(Vec2 ball, Vec2 robot) {
  constexpr double kMiddle = 0.001;  // [m] resolution
  if (std::abs(ball.y) < kMiddle) return robot.y < 0.0 ? -1.0 : 1.0;
  return ball.y > 0.0 ? -1.0 : 1.0;
}

Move travel(const Picture& picture, int robot, Vec2 place, const char* reason,
            std::optional<double> heading) {
  return {
      .twist = twistTo(picture, robot, place, heading), .reason = reason, .place = place, .travels = true};
}

Move standBy(const Picture& picture, int robot, Vec2 place, const char* reason,
             std::optional<double> heading) {
  return travel(picture, robot, apart(picture, place), reason, heading);
}

}  // namespace fulbito::libero
