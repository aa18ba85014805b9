#pragma once

#include <algorithm>
#include <cmath>

#include "tests/support/worlds.hpp"

namespace fulbito::test {

/// [J] of a robot that moves so.
inline double energy(const RobotModel& m, Vec2 velocity, double yaw_rate) {
  return (m.mass * squaredNorm(velocity) + m.inertia() * yaw_rate * yaw_rate) / 2;
}

/// [J] of all robots and balls. A spin that meets a speed s of the ball keeps roll_keep of it.
inline double energy(const World& world) {
  const WorldConfig& config = world.config();
  const WorldState& state = world.state();
  double sum = 0.0;
  for (std::size_t i = 0; i < state.robots.size(); ++i)
    sum += energy(config.robots[i].model, state.robots[i].velocity, state.robots[i].angular_velocity);
  for (std::size_t i = 0; i < state.balls.size(); ++i) {
    const BallModel& ball = config.balls[i].model;
    const double spin = (1.0 - ball.roll_keep) / ball.roll_keep * squaredNorm(state.balls[i].spin);
    sum += ball.mass * (squaredNorm(state.balls[i].velocity) + spin) / 2;
  }
  return sum;
}

/// [m/s] of the fastest point of any robot.
inline double fastestSurface(const World& world) {
  double fastest = 0.0;
  for (std::size_t i = 0; i < world.state().robots.size(); ++i) {
    const RobotState& robot = world.state().robots[i];
    const double swing = std::abs(robot.angular_velocity) * world.config().robots[i].model.circumradius();
    fastest = std::max(fastest, norm(robot.velocity) + swing);
  }
  return fastest;
}

}  // namespace fulbito::test
