#include "strategies/teams/libero/motion/room.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/motion/body.hpp"
#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {
namespace {

/// Whether the opponent is in its own area or enters it before a robot could turn away: such opponents count
/// as keepers.
bool keeps(const Picture& picture, int opponent) {
  const RobotState& other = picture.opponent(opponent);
  return isInArea(picture.pitch.field, other.pose.position, false) ||
         isInArea(picture.pitch.field, other.pose.position + other.velocity * picture.pitch.turn_time, false);
}

/// Whether the two cannot meet before the robot rests, at any heading.
bool isFar(const Pitch& pitch, const RobotState& self, const RobotState& keeper) {
  const double away = squaredNorm(keeper.pose.position - self.pose.position);
  const double near = 4 * pitch.bodies;  // no robot has time to come from farther
  if (away > near * near) return true;
  const double ways =
      mostWay(pitch, norm(self.velocity)) + norm(keeper.velocity) * (pitch.ticks_to_rest * pitch.tick);
  const double apart = ways + pitch.bodies + 2 * pitch.tuning.body_gap;
  return away > apart * apart;
}

/// Whether the circles around the two are too far apart for a touch.
bool isApart(const Pitch& pitch, const RobotState& self, const RobotState& mate) {
  const double near = pitch.bodies + 2 * touchGap(pitch);
  return squaredNorm(mate.pose.position - self.pose.position) > near * near;
}

/// Whether the ball lies between the two. Then the robot meets the keeper at the ball, which is allowed.
bool ballBetween(const Picture& picture, const RobotState& self, const RobotState& keeper) {
  const Vec2 way = keeper.pose.position - self.pose.position;
  const Vec2 ball = intoFrame(unitOr(way, {1.0, 0.0}), picture.seen.ball.position - self.pose.position);
  return ball.x > 0.0 && ball.x < norm(way) && std::abs(ball.y) < picture.pitch.ball_radius;
}

/// Whether the robot that drives `twist` is at the ball in half the time in which a contact with the keeper
/// becomes a foul, or of a quarter turn. Then it disputes the ball.
bool reachesBall(const Picture& picture, const RobotState& self, Twist twist) {
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double time = std::min(pitch.charge_time / 2, pitch.turn_time);
  const double far = mostWay(pitch, norm(self.velocity)) + norm(ball.velocity) * time + 2 * pitch.touch;
  if (squaredNorm(ball.position - self.pose.position) > far * far) return false;
  Roll roll(pitch, self);
  RobotState there = self;
  const int ticks = static_cast<int>(std::lround(time / pitch.tick));
  for (int i = 1; i <= ticks; ++i) {
    roll.drive(twist);
    there.pose = {roll.place, math::angleOf(roll.face)};
    if (atBall(pitch, there, ball.position + ball.velocity * (i * pitch.tick))) return true;
  }
  return false;
}

/// Whether the robot gives way to its mate. A robot at the ball stays there, since opponents would take it.
/// Otherwise each gives way to the keeper, then to the striker, and among supports to the one of smaller
/// rank. A keeper out of its goal leaves the ball to a mate.
bool yields(const Picture& picture, int robot, int mate) {
  const auto at_ball = [&](int i) { return i != picture.keeper && picture.disputes(i); };
  if (at_ball(robot) != at_ball(mate)) {
    if (robot != picture.keeper) return at_ball(mate);
    return std::abs(picture.own(robot).pose.position.y) > picture.pitch.goal_half + picture.pitch.robot_half;
  }
  const auto order = [&](int i) {
    return i == picture.keeper ? -2 : i == picture.striker ? -1 : picture.rank[static_cast<std::size_t>(i)];
  };
  return order(robot) > order(mate);
}

}  // namespace

bool atBall(const Pitch& pitch, const RobotState& robot, Vec2 ball) {
  const Vec2 way = ball - robot.pose.position;
  const double farthest = pitch.touch + touchGap(pitch);
  if (squaredNorm(way) > farthest * farthest) return false;
  const Vec2 local = intoFrame(math::unit(robot.pose.heading), way);
  const Vec2 outside{std::max(0.0, std::abs(local.x) - pitch.robot_half),
                     std::max(0.0, std::abs(local.y) - pitch.robot_half)};
  return norm(outside) < pitch.ball_radius + touchGap(pitch);
}

std::optional<RobotCommand> clearOfKeeper(const Picture& picture, int robot, Twist wanted,
                                          SlideMemory& slide) {
  slide.left -= picture.seen.dt;
  const RobotState& self = picture.own(robot);
  if (picture.disputes(robot) || reachesBall(picture, self, wanted)) return std::nullopt;
  const Pitch& pitch = picture.pitch;
  const bool slides = slide.left > 0.0;
  if (slides) wanted = alongHeading(pitch, self, slide.heading, pitch.speed);
  std::optional<RobotCommand> kept;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    const RobotState& other = picture.opponent(i);
    if (!picture.opponentPresent(i) || isFar(pitch, self, other) || !keeps(picture, i)) continue;
    if (ballBetween(picture, self, other)) continue;
    const Body body{picture, self, other};
    // One that it touches comes before one that it comes near.
    if (body.gap() < touchGap(pitch)) return body.away();
    if (kept || body.allows(wanted)) continue;
    if (slides && body.allows({0.0, wanted.angular})) {
      kept = RobotCommand::byTwist({0.0, wanted.angular});
      continue;
    }
    kept = body.kept(wanted);
    if (!body.goesStraight(wanted)) slide = {pitch.turn_time, body.slideHeading(wanted)};
  }
  return kept || !slides ? kept : RobotCommand::byTwist(wanted);
}

std::optional<RobotCommand> clearOfMates(const Picture& picture, int robot, Twist wanted,
                                         YieldMemory& memory) {
  memory.left -= picture.seen.dt;
  if (memory.left > 0.0) return memory.command;
  const RobotState& self = picture.own(robot);
  const double held = memory.touching;
  // It fades instead of ending at once, since a noisy sight parts robots that touch.
  memory.touching = std::max(0.0, held - picture.seen.dt);
  std::optional<RobotCommand> kept;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (i == robot || !picture.ownPresent(i)) continue;
    const RobotState& mate = picture.own(i);
    if (isFar(picture.pitch, self, mate)) continue;
    const bool first = !yields(picture, robot, i);
    if (first && isApart(picture.pitch, self, mate)) continue;
    const Body body{picture, self, mate};
    const bool touches = body.gap() < touchGap(picture.pitch);
    if (touches) memory.touching = held + picture.seen.dt;
    if (touches && (!first || held > 2 * picture.pitch.turn_time)) {
      memory = {picture.pitch.turn_time, held, body.away()};
      return memory.command;
    }
    if (!kept && !touches && !first && !body.allows(wanted)) kept = body.kept(wanted);
  }
  return kept;
}

}  // namespace fulbito::libero
