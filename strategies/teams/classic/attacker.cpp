#include <array>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/ball_posture.hpp"
#include "strategies/skills/interception.hpp"
#include "strategies/skills/kicking.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/skills/shot_geometry.hpp"
#include "strategies/teams/classic/classic_team.hpp"

namespace fulbito {

/// Turning in place; `sense` is +1 (counter-clockwise) or -1.
RobotCommand Classic::spinning(double sense) {
  constexpr double kYawRate = 30.0;  // [rad/s] about as fast as the wheels allow
  return RobotCommand::byTwist({0.0, sense * kYawRate});
}

Vec2 Classic::aim(const Observation& now, Vec2 ball) const {
  std::array<ShotBlocker, kMaxTeamSize> blockers;
  std::array<Vec2, kMaxTeamSize> places;
  std::size_t count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(now.team_size); ++i) {
    if (!now.opponents[i].present) continue;
    const RobotState& state = now.opponents[i].state;
    places[count] = state.pose.position;
    blockers[count++] = {state.pose.position, info_.robot.length / 2, state.velocity};
  }
  if (ball.x < -info_.field.length / 4) return clearanceTarget(info_.field, ball, {places.data(), count});
  ShotModel model;
  model.ball_radius = info_.ball.radius;
  auto shot = bestShot(info_.field, model, ball, {blockers.data(), count});
  // If the keeper reaches every shot in time, compare the gaps without its motion.
  model.acceleration = 0.0;
  if (!shot) shot = bestShot(info_.field, model, ball, {blockers.data(), count});
  return shot.value_or(opponentGoal(info_.field));
}

/// Wanted direction of the ball: to the free part of the goal, from the own third up a side, or along a wall
/// at which it lies.
Vec2 Classic::wantedDirection(const Observation& now, Vec2 ball) const {
  constexpr double kAtWall = 0.02;  // [m] a narrower gap at a wall has no room for a robot
  const FieldGeometry& field = info_.field;
  const double reach = info_.ball.radius + kAtWall;
  if (field.width / 2 - std::abs(ball.y) < reach) return {1.0, 0.0};
  if (field.length / 2 - ball.x < reach && std::abs(ball.y) > field.goal_width / 2) {
    return {0.0, ball.y > 0.0 ? -1.0 : 1.0};
  }
  return unitOr(aim(now, ball) - ball, {1.0, 0.0});
}

/// Whether an opponent reaches the ball before the attacker, which needs `mine` [s], can line up.
bool Classic::isContested(const Observation& now, double mine) const {
  constexpr double kReserve = 0.15;  // [s]
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    if (!now.opponents[k].present) continue;
    const double theirs = timeToReach(foresight_.pace(), now.opponents[k].state, now.ball.position);
    if (theirs < mine + kReserve) return true;
  }
  return false;
}

/// Whether the ball lies in the opponents' area with an opponent at it.
bool Classic::isHeldByKeeper(const Observation& now) const {
  constexpr double kSlow = 0.3, kAtBall = 0.085;  // [m/s], [m]
  if (norm(now.ball.velocity) > kSlow || !isInArea(info_.field, now.ball.position, false)) return false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    const ObservedRobot& opponent = now.opponents[k];
    if (opponent.present && distance(opponent.state.pose.position, now.ball.position) < kAtBall) return true;
  }
  return false;
}

std::optional<RobotCommand> Classic::spinAtBall(const Observation& now, std::size_t i, bool contested) {
  const RobotState& robot = now.own[i].state;
  const Vec2 ball = now.ball.position;
  SpinSettings settings;
  Vec2 wanted{1.0, -0.3 * std::copysign(1.0, ball.y)};
  const bool at_mouth =
      ball.x > info_.field.length / 2 - 0.08 && std::abs(ball.y) < info_.field.goal_width / 2;
  if (at_mouth) {
    wanted = {1.0, 0.0};
    settings.slow = 2.0;  // a ball in front of the mouth rolls past if the robot waits
    settings.wall = 0.10;
  } else if (contested && std::abs(ball.x) < info_.field.length / 2 - 0.15) {
    settings.wall = 1.0;  // the ball is held between two robots; no wall is needed
  }
  const auto sense = memory_[i].spin.update(info_.field, info_.ball.radius, robot, now.ball, wanted,
                                            params_.spin, now.dt, settings);
  if (!sense) return std::nullopt;
  return spinning(*sense);
}

RobotCommand Classic::attacker(const Observation& now, std::size_t i) {
  constexpr double kAreaMargin = 0.07;  // [m]
  Memory& memory = memory_[i];
  const RobotState& robot = now.own[i].state;
  const BallPrediction& prediction = foresight_.ball();
  const auto meeting = intercept(prediction, foresight_.pace(), robot);
  const Vec2 ball = meeting ? meeting->ball : prediction.endOfWay();
  const bool keeper_plays = now.own[0].present && i != 0;
  if (keeper_plays && isInArea(info_.field, ball, true)) {
    GoTo wait;
    wait.position = outsideArea(info_.field, ball + Vec2{0.1, 0.0}, true, kAreaMargin);
    return RobotCommand::drivingTo(wait);
  }
  if (isHeldByKeeper(now)) {
    // Charging a keeper in its area is a foul.
    GoTo wait;
    wait.position = reboundSpot(info_.field, -ball);
    return RobotCommand::drivingTo(wait);
  }
  const bool contested = isContested(now, meeting ? meeting->time : 10.0);
  if (isKicking(now, i)) return RobotCommand::byTwist({info_.robot.maxSpeed(), 0.0});
  if (const auto spin = spinAtBall(now, i, contested)) return *spin;
  const Vec2 direction = wantedDirection(now, ball);
  memory.lined_up = isLinedUp(sideOfBall(robot, now.ball.position, direction), memory.lined_up);
  if (memory.lined_up) {
    return RobotCommand::byTwist(strike(robot, now.ball.position, direction, params_.strike_speed));
  }
  // A contested ball is hit straight, as long as that sends it upfield.
  constexpr double kUpfield = 0.2;
  const Vec2 straight = unitOr(ball - robot.pose.position, {1.0, 0.0});
  if (contested && straight.x > kUpfield) {
    return RobotCommand::byTwist(strike(robot, ball, straight, params_.strike_speed));
  }
  BallApproach approach = approachBall(robot, ball, direction, memory.round);
  memory.round = approach.round;
  GoTo& go_to = approach.go_to;
  constexpr double kBodyMargin = 0.04;  // [m]
  go_to.position = insideWalls(info_.field, go_to.position, kBodyMargin);
  if (keeper_plays) go_to.position = outsideArea(info_.field, go_to.position, true, kAreaMargin);
  // Near the ball all robots are in the way: as obstacles they would turn the field away from the ball.
  const bool near = distance(robot.pose.position, ball) < 0.25;
  go_to.avoid_opponents = !near;
  go_to.avoid_mates = !near;
  return RobotCommand::drivingTo(go_to);
}

}  // namespace fulbito
