#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "fulbito/world.hpp"

namespace fulbito::test {

/// How deep two outlines are in each other [m], by separating axes; negative where they are apart.
inline double depthOf(const RobotModel& model, const Pose2& a, const Pose2& b) {
  const Vec2 ahead_a = math::unit(a.heading), ahead_b = math::unit(b.heading);
  const auto extent = [&](Vec2 axis, Vec2 ahead) {
    return std::abs(dot(axis, ahead)) * model.length / 2 + std::abs(cross(axis, ahead)) * model.width / 2;
  };
  double least = INFINITY;
  for (Vec2 axis : std::array{ahead_a, perp(ahead_a), ahead_b, perp(ahead_b)}) {
    const double apart = std::abs(dot(axis, b.position - a.position));
    least = std::min(least, extent(axis, ahead_a) + extent(axis, ahead_b) - apart);
  }
  return least;
}

/// The same of a robot and a disc.
inline double depthOf(const RobotModel& model, const Pose2& robot, Vec2 disc, double radius) {
  const Vec2 ahead = math::unit(robot.heading), to = disc - robot.position;
  const double x = std::abs(dot(ahead, to)) - model.length / 2,
               y = std::abs(cross(ahead, to)) - model.width / 2;
  if (x <= 0.0 && y <= 0.0) return radius - std::max(x, y);
  return radius - norm(Vec2{std::max(x, 0.0), std::max(y, 0.0)});
}

/// Deepest of all pairs of a world.
struct Depths {
  double ball = -INFINITY;   ///< [m] ball in robot
  double robot = -INFINITY;  ///< [m] robot in robot

  void look(const RobotModel& model, double ball_radius, const WorldState& world) {
    for (std::size_t i = 0; i < world.robots.size(); ++i) {
      const Pose2& pose = world.robots[i].pose;
      for (const BallState& b : world.balls)
        ball = std::max(ball, depthOf(model, pose, b.position, ball_radius));
      for (std::size_t k = i + 1; k < world.robots.size(); ++k) {
        robot = std::max(robot, depthOf(model, pose, world.robots[k].pose));
      }
    }
  }
};

}  // namespace fulbito::test
