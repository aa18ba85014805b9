#include "strategies/teams/libero/attack/striker.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/teams/libero/attack/blow.hpp"
#include "strategies/teams/libero/attack/caught.hpp"
#include "strategies/teams/libero/attack/corner.hpp"
#include "strategies/teams/libero/attack/meet.hpp"
#include "strategies/teams/libero/motion/room.hpp"

namespace fulbito::libero {
namespace {

constexpr double kTouch = 0.075;    // [m] between the centres of robot and ball that about touch
constexpr double kSpinTime = 0.45;  // [s]
constexpr double kDispute = 2.0;  // [s] time after a free ball or penalty in which the robot only presses on
constexpr double kPinched = 0.3;  // [s] of pressing, after which the robot lets a pinched ball slip out
constexpr double kSlip = 0.3;     // [s] time that the robot lets it slip
constexpr double kSlipTurn = 0.15;   // [rad] turn of the face; at 0.25 the opponent gets the ball
constexpr double kCrowd = 0.16;      // [m] opponents nearer than this to the ball are in the way
constexpr double kRunUp = 0.065;     // [m] from the ball's centre to the striker's when they touch
constexpr double kAlongWall = 0.15;  // [m] length of the drawn line of a ball that is sent along a wall

Twist spin(StrikerMemory& memory, double dt) {
  memory.spin_left -= dt;
  if (memory.spin_left <= 0.0) memory.locked = 0.4;
  return {0.0, memory.spin_sense * 28.0};
}

/// Measures how long robot and ball have pressed on something without motion.
void watchJam(const Picture& picture, const RobotState& robot, Vec2 rel, StrikerMemory& memory) {
  const bool slow =
      squaredNorm(picture.ball.now().velocity) < 0.08 * 0.08 && squaredNorm(robot.velocity) < 0.12 * 0.12;
  const bool near = squaredNorm(rel) < kTouch * kTouch;
  memory.jammed = slow && near ? memory.jammed + picture.seen.dt : 0.0;
  memory.locked = std::max(0.0, memory.locked - picture.seen.dt);
}

}  // namespace

Interception interception(const Picture& picture, const RobotState& robot) {
  const Vec2 goal = picture.pitch.theirGoal();
  const auto strike_point = [&](Vec2 ball) { return ball - unitOr(goal - ball, {1.0, 0.0}) * 0.04; };
  if (picture.ball.resting()) {
    const Vec2 ball = picture.ball.sample(0);
    return {timeToReach(picture.pitch.pace, robot, strike_point(ball)), ball};
  }
  const Runner runner{robot.pose.position, math::unit(robot.pose.heading), robot.velocity};
  double late = 0.0;  // [s] by which the robot is too late at the previous step
  for (int i = 0; i <= BallForecast::kSteps; i += 2) {
    const double time = i * BallForecast::kStep;
    const Vec2 ball = picture.ball.sample(i);
    const double least = picture.pitch.speed * time + 0.12;
    if (squaredNorm(ball - robot.pose.position) > least * least && i < BallForecast::kSteps) continue;
    const double needed = timeToReach(picture.pitch.pace, runner, strike_point(ball));
    if (needed <= time || i == BallForecast::kSteps) {
      if (i == 0) return {needed, ball};
      const double early = time - needed;
      const double at =
          late > 0.0 && early > 0.0 ? time - 2 * BallForecast::kStep * early / (early + late) : time;
      return {std::max(at, needed - 0.1), picture.ball.at(at)};
    }
    late = needed - time;
  }
  return {};
}

namespace {

/// Whether at an own penalty an opponent leaves its goal toward the ball. In the first 0.05 s, when its
/// motion cannot be seen yet, the answer is yes.
bool keeperRunsOut(const Picture& picture) {
  const Observation& seen = picture.seen;
  if (seen.restart != RestartKind::kPenalty || !seen.restart_is_ours || seen.since_restart > kDispute)
    return false;
  if (seen.since_restart < 0.05) return true;
  for (int i = 0; i < seen.team_size; ++i) {
    if (!picture.opponentPresent(i)) continue;
    const RobotState& other = picture.opponent(i);
    if (other.pose.position.x < picture.ball.now().position.x - 0.1) continue;
    if (other.pose.position.x < picture.pitch.half_length - 0.12 || other.velocity.x < -0.15) return true;
  }
  return false;
}

/// Whether an opponent is near enough to take the ball from a robot that turns away to aim. Otherwise the
/// robot aims, since a straight push sends the ball into the opponents' corner, from where it returns along
/// the wall.
bool contested(const Picture& picture) {
  constexpr double kNear = 0.22;  // [m]
  return picture.seen.since_restart < 0.1 || picture.opponentsNear(picture.ball.now().position, kNear) > 0;
}

/// Whether a quick touch matters more than its direction: right after a restart, or when their keeper runs
/// out. A robot that drives round the ball would lose it then.
bool rushes(const Picture& picture, Vec2 rel) {
  if (keeperRunsOut(picture)) return true;
  if (squaredNorm(rel) < 0.055 * 0.055) return false;
  const double since = picture.seen.since_restart;
  if (picture.seen.restart == RestartKind::kKickOff) return since < 0.4;
  return picture.seen.restart == RestartKind::kGoalKick && !picture.seen.restart_is_ours && since < 0.5;
}

/// The wanted point [m] of the first touch. In five-a-side matches a free ball is met on its inner side.
/// There it slips out between the two robots toward the side wall, away from the own goal.
Vec2 firstTouch(const Picture& picture) {
  const Vec2 ball = picture.ball.now().position;
  if (picture.seen.restart != RestartKind::kFreeBall || !picture.pitch.isLarge()) return ball;
  return ball - Vec2{0.0, std::copysign(kInner, ball.y)};
}

/// Drives straight at the ball, since a robot that drives round it would lose it. If two robots push with
/// equal force, nothing moves until one turns its face slightly. Then the ball slips out to the side wall,
/// and the robot that turned first reaches it first.
Twist pressOn(const Picture& picture, const RobotState& self, Vec2 rel, StrikerMemory& memory) {
  const Pitch& pitch = picture.pitch;
  memory.slipping = memory.jammed > kPinched ? kSlip : memory.slipping - picture.seen.dt;
  if (memory.slipping <= 0.0) return passThrough(self, firstTouch(picture), pitch.speed);
  const double out = std::copysign(kSlipTurn, picture.ball.now().position.y);
  return alongHeading(self, math::angleOf(rel) + out, pitch.speed);
}

/// Whether an opponent presses from the other side against the ball that the robot pushes roughly in the
/// wanted direction.
bool headOn(const Picture& picture, Vec2 rel, const Aim& aim) {
  const double near = norm(rel);
  if (aim.wall || near > kTouch || dot(rel, aim.direction) < 0.5 * near) return false;
  return picture.opponentsNear(picture.ball.now().position + unitOr(rel, {}) * 0.06, 0.03) > 0;
}

/// Whether the ball runs along the opponents' goal line through the mouth, in front of the robot. Then the
/// robot turns it in while it pushes. A robot that drives round it would arrive after the ball has passed the
/// other post.
bool sweepsIn(const Picture& picture, Vec2 rel) {
  constexpr double kBefore = 0.12;  // [m] before the line
  constexpr double kPast = 0.03;    // [m] past a post
  constexpr double kNear = 0.085;   // [m]
  constexpr double kBehind = 0.01;  // [m] by which the robot may be nearer to the line
  constexpr double kRolls = 0.15;   // [m/s]
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  if (ball.position.x < pitch.half_length - kBefore || std::abs(ball.position.y) > pitch.goal_half + kPast)
    return false;
  return squaredNorm(rel) < kNear * kNear && rel.x > -kBehind && std::abs(ball.velocity.y) > kRolls &&
         rel.y * ball.velocity.y > 0.0;
}

/// Follows the ball with a small component into the goal. A larger component would lose the ball sideways.
Twist sweepIn(const Picture& picture, const RobotState& self) {
  constexpr double kInto = 0.4;
  const double across = std::copysign(1.0, picture.ball.now().velocity.y);
  return alongHeading(self, math::angleOf({kInto, across}), picture.pitch.speed);
}

}  // namespace

bool disputesFreeBall(const Observation& seen) {
  return seen.restart == RestartKind::kFreeBall && seen.since_restart < kDispute;
}

Move strike(const Picture& picture, int robot, StrikerMemory& memory) {
  const RobotState& self = picture.own(robot);
  const Pitch& pitch = picture.pitch;
  const BallState& now = picture.ball.now();
  const Vec2 rel = now.position - self.pose.position;
  watchJam(picture, self, rel, memory);
  if (memory.spin_left > 0.0) return {spin(memory, picture.seen.dt), "spin", {}, {}, {}};

  const Vec2 touch = firstTouch(picture);
  if (disputesFreeBall(picture.seen) && contested(picture))
    return {pressOn(picture, self, rel, memory), "press", {}, touch, {}};
  if (rushes(picture, rel)) return {passThrough(self, touch, pitch.speed), "rush", {}, touch, {}};
  if (canBlockDribble(picture, self)) return blockDribble(picture, self);
  if (const auto round = roundKeeper(picture, robot, now.position))
    return {*round, "round keeper", {}, now.position, {}};
  if (isCaught(picture, self, memory)) return {driveOff(pitch, self), "drive off", {}, {}, {}};
  const bool close = squaredNorm(rel) < 0.10 * 0.10;
  const Vec2 ball = close ? now.position + now.velocity * 0.03 : interception(picture, self).ball;
  memory.target_y = openMouth(picture, ball, self.pose.position.y, memory.target_y);
  const Vec2 target{pitch.half_length + 0.02, memory.target_y};
  Aim aim = aimAt(pitch, ball, target);
  const bool pinned = aim.wall && squaredNorm(rel) < 0.085 * 0.085 && squaredNorm(now.velocity) < 0.2 * 0.2 &&
                      dot(unitOr(rel, {}), aim.direction) < 0.5;
  if (now.position.x > 0.5 && (memory.jammed > 0.35 || pinned) && memory.locked <= 0.0) {
    memory.spin_left = kSpinTime;
    memory.jammed = 0.0;
    memory.spin_sense = cross(rel, aim.direction) >= 0.0 ? 1.0 : -1.0;
    return {spin(memory, picture.seen.dt), "spin", {}, {}, {}};
  }
  if (sweepsIn(picture, rel)) return {sweepIn(picture, self), "sweep in", {}, now.position, {}};
  if (headOn(picture, rel, aim)) return {pressOn(picture, self, rel, memory), "press", {}, touch, {}};
  if (squeezes(picture, rel, aim)) return {squeeze(picture, self, rel, aim), "squeeze", {}, now.position, {}};
  if (racesAlongWall(picture, rel, aim))
    return {raceAlongWall(picture, self, aim), "race", {}, aim.contact, {}};
  if (!aim.wall) aim.direction = blowInTime(self.pose.position, aim, now.velocity);
  if (squaredNorm(rel) < 0.35 * 0.35)
    aim.direction = clearStrikeDirection(picture, robot, aim, memory.direction_index);
  const double round = kRound + 0.03 * std::min(2, picture.opponentsNear(now.position, kCrowd));
  const Vec2 behind = insideWalls(pitch.field, aim.contact - aim.direction * kRunUp, pitch.robot_half);
  const Vec2 sent = aim.wall ? insideWalls(pitch.field, ball + aim.direction * kAlongWall, 0.0) : target;
  return {driveThrough(pitch, self, aim.contact, aim.direction, round, now.velocity, memory.side), "", behind,
          ball, sent};
}

}  // namespace fulbito::libero
