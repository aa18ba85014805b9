#include "strategies/teams/libero/defence/goal_line.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/teams/libero/motion/approach.hpp"

namespace fulbito::libero {
namespace {

/// The heading [rad] on a circle round a ball that lies on the keeper's way back to `place`; empty if its way
/// is free. A keeper that drove on would push the ball into its own goal.
std::optional<double> headingRoundBall(const Pitch& pitch, Vec2 self, Vec2 place, Vec2 ball) {
  const Vec2 way = place - self, to_ball = ball - self;
  const double radius = pitch.touch + pitch.tuning.clearance;
  const Vec2 local = intoFrame(unitOr(way, {-1.0, 0.0}), to_ball);
  if (to_ball.x > 0.0 || local.x < 0.0 || local.x > norm(way) + pitch.touch || std::abs(local.y) > radius)
    return std::nullopt;
  return math::angleOf(to_ball) - std::copysign(tangentAngle(radius, norm(to_ball)), local.y);
}

}  // namespace

std::optional<double> crossing(const Picture& picture, double line) {
  Vec2 before = picture.ball.sample(0);
  if (picture.ball.resting() || before.x < line) return std::nullopt;
  for (int i = 1; i <= BallForecast::kSteps; ++i) {
    const Vec2 after = picture.ball.sample(i);
    if (after.x <= line) {
      const double part = (before.x - line) / std::max(1e-9, before.x - after.x);
      return before.y + (after.y - before.y) * part;
    }
    before = after;
  }
  return std::nullopt;
}

// Until the ball arrives at a post, the keeper covers a part of the gap. Half of the difference of both
// parts, toward the post that the ball reaches sooner, leaves equal rests of both gaps.
double evenRestPlace(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.sample(1), post{0.0, pitch.goal_half};
  const double speed = norm(picture.ball.now().velocity);
  const double left = timeAlong(pitch.pace, distance(ball, pitch.ownGoal() + post), speed);
  const double right = timeAlong(pitch.pace, distance(ball, pitch.ownGoal() - post), speed);
  return equalGapPoint(pitch.field, ball, keeperDepth(pitch)).y +
         (wayFromRest(pitch.pace, right) - wayFromRest(pitch.pace, left)) / 2;
}

std::optional<double> shotAtKeeper(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const auto shot = crossing(picture, keeperLine(pitch) + pitch.ball_radius);
  return shot && std::abs(*shot) < pitch.goal_half + pitch.robot_corner ? shot : std::nullopt;
}

double withinMouth(const Pitch& pitch, double y) {
  const double most = pitch.goal_half - pitch.ball_radius;
  return std::clamp(y, -most, most);
}

double readyPlace(const Picture& picture) { return withinMouth(picture.pitch, evenRestPlace(picture)); }

bool shotComes(const Picture& picture) {
  const auto shot = crossing(picture, -picture.pitch.half_length);
  return shot && std::abs(*shot) < picture.pitch.goal_half + picture.pitch.ball_radius;
}

bool mustSave(const Picture& picture, int robot) {
  const Pitch& pitch = picture.pitch;
  const Vec2 place = picture.own(robot).pose.position;
  return shotComes(picture) && place.x < -pitch.half_length + pitch.area_front + pitch.bodies &&
         picture.ball.now().position.x > place.x;
}

bool ballAlongEndWall(const Picture& picture, double width) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  return ball.x < -pitch.half_length + pitch.touch && std::abs(ball.y) > pitch.bodies &&
         std::abs(ball.y) < width;
}

bool closesEndWall(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const double y = picture.ball.now().position.y, out = std::copysign(1.0, y);
  return self.pose.position.x < -pitch.half_length + pitch.touch + pitch.tuning.clearance &&
         self.pose.position.y * out < y * out - pitch.ball_radius;
}

Twist alongLine(const Pitch& pitch, const RobotState& self, double line, double speed) {
  const double dx = line - self.pose.position.x;
  const double most = pitch.tuning.turn_in;
  const double lean =
      std::clamp(dx / pitch.around, -most, most) * std::min(1.0, std::abs(speed) / pitch.tuning.lies);
  const double along = speed >= 0.0 ? math::kPi / 2 - lean : -math::kPi / 2 + lean;
  const double error = foldedError(along, self.pose.heading);
  const double face = std::abs(math::wrapAngle(along - self.pose.heading)) > math::kPi / 2 ? -1.0 : 1.0;
  return {face * std::abs(speed) * std::max(0.0, math::cos(error)),
          std::clamp(pitch.tuning.rest_gain * error, -pitch.turn_rate, pitch.turn_rate)};
}

double stoppableSpeed(const Pitch& pitch, double way) {
  return std::min(stoppingSpeed(pitch.plannedBraking(), std::abs(way)),
                  pitch.tuning.rest_gain * std::abs(way));
}

Twist slideTo(const Picture& picture, const RobotState& self, double line, double y) {
  const Pitch& pitch = picture.pitch;
  const double dx = line - self.pose.position.x, dy = y - self.pose.position.y;
  const Vec2 rel = picture.ball.now().position - self.pose.position;
  if (dx > pitch.ball_radius && norm(rel) < pitch.touch + pitch.front && rel.x > 0.0) {
    // The keeper is behind its line with the ball in front of it. It stays parallel to the line in front of
    // the ball, because a turn would let the ball in.
    const double along = self.pose.heading >= 0.0 ? math::kPi / 2 : -math::kPi / 2;
    const double ahead = picture.ball.sample(1).y - self.pose.position.y;
    return {std::copysign(1.0, self.pose.heading) *
                std::clamp(pitch.tuning.rest_gain * ahead, -pitch.speed, pitch.speed),
            std::clamp(pitch.tuning.push_gain * foldedError(along, self.pose.heading), -pitch.turn_rate / 2,
                       pitch.turn_rate / 2)};
  }
  if (std::abs(dx) > pitch.front) {
    const auto round = headingRoundBall(pitch, self.pose.position, {line, y}, picture.ball.sample(1));
    if (round) return alongHeading(pitch, self, *round, pitch.speed);
  }
  if (std::abs(dx) > pitch.front || std::abs(dy) > 2 * pitch.goal_half)
    return restAt(pitch, self, {line, y}, math::kPi / 2, pitch.ball_radius);
  return alongLine(pitch, self, line, std::copysign(std::min(pitch.speed, stoppableSpeed(pitch, dy)), dy));
}

}  // namespace fulbito::libero
