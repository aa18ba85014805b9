#include "strategies/skills/goalkeeping.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/skills/quick_twist.hpp"

namespace fulbito {

bool LineKeeper::mayLeave(const MatchInfo& info, const Foresight& foresight, const Observation& now,
                          std::size_t i, const Settings& settings) const {
  constexpr double kSlow = 0.3;  // [m/s]
  const Vec2 ball = now.ball.position;
  const RobotState& robot = now.own[i].state;
  const bool near = isInArea(info.field, ball, true) && distance(ball, ownGoal(info.field)) < settings.leash;
  // A ball beside or behind the keeper would go past it into the goal.
  if (!near || norm(now.ball.velocity) > kSlow || ball.x < robot.pose.position.x + info.ball.radius)
    return false;
  if (now.restart == RestartKind::kGoalKick && now.restart_is_ours && now.since_restart < 2.0) return true;
  const double mine = timeToReach(foresight.pace(), robot, ball);
  const double lead = out_ ? 0.0 : settings.lead;
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    if (!now.opponents[k].present) continue;
    if (timeToReach(foresight.pace(), now.opponents[k].state, ball) < mine + lead) return false;
  }
  return true;
}

/// Slides along the line to `place`. A robot cannot move sideways: off the line, it leans toward it while it
/// slides, and strokes to and fro while it has nothing else to do.
Twist LineKeeper::slide(const MatchInfo& info, const RobotState& robot, Vec2 place) {
  constexpr double kGain = 9.0, kTurn = 12.0;      // [1/s]
  constexpr double kLean = 12.0, kMost = 0.5;      // [rad/m], [rad]
  constexpr double kStroke = 0.025, kOff = 0.008;  // [m]
  constexpr double kTurnFirst = 0.7;               // [rad]
  Vec2 off = place - robot.pose.position;
  if (std::abs(off.x) > kOff && std::abs(off.y) < 2.0 * kStroke) {
    if (stroke_ == 0.0) stroke_ = std::copysign(1.0, off.y);
    if (std::abs(off.y + stroke_ * kStroke) < 0.005) stroke_ = -stroke_;
    off.y += stroke_ * kStroke;
  }
  const double sign = math::sin(robot.pose.heading) >= 0.0 ? 1.0 : -1.0;  // the end nearer to +y is the front
  const double lean = std::clamp(kLean * off.x, -kMost, kMost) * (off.y >= 0.0 ? -1.0 : 1.0);
  const double error =
      math::wrapAngle(sign * math::kPi / 2 + (std::abs(off.y) > 0.01 ? lean : 0.0) - robot.pose.heading);
  const double top = info.robot.maxSpeed();
  const double v = std::abs(error) > kTurnFirst ? 0.0 : std::clamp(kGain * off.y, -top, top);
  return {sign * v, kTurn * error};
}

RobotCommand LineKeeper::update(const MatchInfo& info, const Foresight& foresight, const Observation& now,
                                std::size_t i, const Settings& settings) {
  const RobotState& robot = now.own[i].state;
  const Vec2 ball = now.ball.position;
  const double depth = info.robot.width / 2 + settings.gap;
  const double side = ball.y >= robot.pose.position.y ? 1.0 : -1.0;
  const bool in_front = ball.x > robot.pose.position.x - info.ball.radius;
  // Spins send the ball outward and upfield, never across the own mouth.
  SpinSettings spins;
  spins.slow = 0.6, spins.wall = 1.0;
  spins.longest = 1.5, spins.lock_out = 0.1;
  spins.reach = info.robot.circumradius() + info.ball.radius;
  const auto sense =
      spin_.update(info.field, info.ball.radius, robot, now.ball, {0.5, side}, in_front, now.dt, spins);
  constexpr double kYawRate = 30.0;  // [rad/s] the limiter reduces it to what the robot can
  if (sense) return quickTwist(info.robot, robot, {0.0, *sense * kYawRate}, now.dt);
  out_ = mayLeave(info, foresight, now, i, settings);
  // A penalty is met far out: on the line, ball and taker push the keeper into the goal.
  const bool penalty =
      now.restart == RestartKind::kPenalty && !now.restart_is_ours && now.since_restart < 1.0;
  if (out_ || penalty) {
    DriveGoal clear;
    clear.ball = ball;
    clear.direction = unitOr(ball - (penalty ? robot.pose.position : ownGoal(info.field)), {1.0, 0.0});
    return quickTwist(info.robot, robot, drive_.update(info, robot, clear), now.dt);
  }
  // A ball carried along the end wall is pushed back the way it came: beside the post nothing is lost.
  const double beside = std::abs(ball.y) - info.field.goal_width / 2;
  const bool along_wall = ball.x < -info.field.length / 2 + 2.0 * depth && beside > -info.robot.length / 2 &&
                          beside < info.robot.length * 2.5;
  const double farthest = info.field.goal_width / 2 - info.robot.length / 2 + info.ball.radius;
  Vec2 place = keeperPoint(info.field, foresight.ball(), depth, farthest, info.ball.radius);
  if (along_wall && std::abs(robot.pose.position.x - place.x) < 0.03 && side * ball.y > 0.0)
    place.y = ball.y + side * 0.1;
  const double off_line = std::abs(robot.pose.position.x - place.x);
  if (off_line < 0.08 && std::abs(robot.pose.position.y) < info.field.goal_width / 2 + 0.05)
    return quickTwist(info.robot, robot, slide(info, robot, place), now.dt);
  GoTo back;
  back.position = place;
  back.heading = math::kPi / 2;
  back.stop = true;
  back.avoid_mates = back.avoid_opponents = false;
  return RobotCommand::drivingTo(back);
}

}  // namespace fulbito
