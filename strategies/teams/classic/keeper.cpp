#include <array>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/ball_posture.hpp"
#include "strategies/skills/line_keeping.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/classic/classic_team.hpp"

namespace fulbito {

RobotCommand Classic::keeper(const Observation& now, std::size_t i) {
  const RobotState& robot = now.own[i].state;
  const double farthest = info_.field.goal_width / 2 - 0.02;
  const Vec2 place = keeperPoint(info_.field, foresight_.ball(), params_.keeper_depth, farthest);
  const Vec2 ball = now.ball.position;
  // Spins only send the ball outward and upfield, never across the own goal mouth.
  const Vec2 out{0.5, ball.y >= robot.pose.position.y ? 1.0 : -1.0};
  const bool in_front = ball.x > robot.pose.position.x - 0.01;
  const auto sense = memory_[i].spin.update(info_.field, info_.ball.radius, robot, now.ball, out,
                                            params_.spin && in_front, now.dt, {.slow = 0.5, .wall = 0.3});
  if (sense) return spinning(*sense);
  // The keeper meets a penalty far out, facing the ball. On the line it would be pushed into the goal with
  // the ball.
  const bool penalty =
      now.restart == RestartKind::kPenalty && !now.restart_is_ours && now.since_restart < 1.0;
  if (penalty || mayClear(now, i)) return clearing(now, i);
  if (const auto twist = keepLine(robot, place, info_.robot.maxSpeed())) return RobotCommand::byTwist(*twist);
  GoTo back;
  back.position = place;
  back.heading = math::kPi / 2;
  back.stop = true;
  return RobotCommand::drivingTo(back);
}

/// Whether the keeper leaves its line: for a slow ball near the goal that no opponent reaches soon.
bool Classic::mayClear(const Observation& now, std::size_t i) const {
  constexpr double kSlow = 0.3, kLead = 0.15;  // [m/s], [s]
  const Vec2 ball = now.ball.position;
  if (norm(now.ball.velocity) > kSlow || !isInArea(info_.field, ball, true, 0.02)) return false;
  // The keeper cannot clear a ball behind its back.
  const RobotState& robot = now.own[i].state;
  if (ball.x < robot.pose.position.x + 0.02) return false;
  if (now.restart == RestartKind::kGoalKick && now.restart_is_ours && now.since_restart < 2.0) return true;
  const double mine = timeToReach(foresight_.pace(), robot, ball);
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    if (!now.opponents[k].present) continue;
    if (timeToReach(foresight_.pace(), now.opponents[k].state, ball) < mine + kLead) return false;
  }
  return true;
}

RobotCommand Classic::clearing(const Observation& now, std::size_t i) {
  const Vec2 ball = now.ball.position;
  const Vec2 away = unitOr(ball - now.own[i].state.pose.position, {1.0, 0.0});
  return RobotCommand::byTwist(strike(now.own[i].state, ball, away, params_.strike_speed));
}

}  // namespace fulbito
