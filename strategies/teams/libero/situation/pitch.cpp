#include "strategies/teams/libero/situation/pitch.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::libero {

Pitch::Pitch(const MatchInfo& info, const Tuning& tuned)
    : tuning(tuned),
      field(info.field),
      pace(info.robot),
      half_length(info.field.length / 2),
      half_width(info.field.width / 2),
      goal_half(info.field.goal_width / 2),
      area_half(info.field.goal_area_width / 2),
      area_front(info.field.goal_area_depth + info.field.goal_area_arc_depth),
      ball_radius(info.ball.radius),
      robot_half(std::max(info.robot.length, info.robot.width) / 2),
      robot_corner(info.robot.circumradius()),
      speed(info.robot.maxSpeed()),
      acceleration(pace.acceleration),
      braking(pace.braking),
      turning(info.robot.turnAcceleration()),
      sliding(info.robot.lateral_grip),
      half_track(info.robot.axle_track / 2),
      wheel_radius(info.robot.wheel_radius),
      tick(info.physics.controlPeriod()),
      front(robot_half + ball_radius),
      touch(robot_corner + ball_radius),
      bodies(2 * robot_corner),
      around(2 * front),
      ticks_to_rest(1 + static_cast<int>(std::ceil(speed / (plannedBraking() * tick)))),
      ticks_to_start(1 + static_cast<int>(std::sqrt(2 * tuning.clearance / acceleration) / tick)),
      stop_time(speed / braking),
      turn_time(timeToTurn(pace, math::kPi / 2)),
      turn_rate(stoppingSpeed(turning, math::kPi / 4)),
      creep(stoppingSpeed(info.ball.roll_deceleration, ball_radius)),
      bounce((1.0 + info.ball.robot_restitution) * info.robot.mass / (info.robot.mass + info.ball.mass)),
      rub(std::sqrt(info.robot.friction * info.ball.friction)),
      roll_keep(info.ball.roll_keep),
      slide_deceleration(info.ball.slide_deceleration),
      stuck_radius(info.rules.stuck.radius),
      stuck_time(info.rules.stuck.seconds),
      charge_time(info.rules.keeper.charge_seconds),
      shoves(2 * pace.acceleration > pace.braking),
      motors(info.robot, tick),
      team_size(info.rules.team_size) {}

}  // namespace fulbito::libero
