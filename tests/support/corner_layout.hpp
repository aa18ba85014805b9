#pragma once

#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/navigation.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito::test {

/// The corner-to-corner problem of the comparison, centre coordinates: four tennis balls, two in the lower
/// left and two in the upper right box, at least two within 8.65 cm of the straight line; start and goal in
/// opposite corners.
struct CornerLayout {
  Pose2 start;
  NavigationGoal goal;
  std::vector<DiscObstacle> obstacles;
};

inline CornerLayout cornerLayout(std::uint64_t seed) {
  Rng rng(seed, kTestStream);
  const Vec2 origin{0.75, 0.65}, start{0.12, 0.12}, goal{1.38, 1.18};
  const Vec2 along = unitOr(goal - start, {});
  for (;;) {
    std::vector<Vec2> balls;
    for (int i = 0; i < 4; ++i) {
      balls.push_back(i < 2 ? Vec2{rng.uniform(0.25, 0.70), rng.uniform(0.20, 0.60)}
                            : Vec2{rng.uniform(0.80, 1.25), rng.uniform(0.70, 1.10)});
    }
    int near = 0;
    bool apart = true;
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::abs(cross(along, balls[i] - start)) < 0.0865) ++near;
      if (distance(balls[i], start) < 0.12 || distance(balls[i], goal) < 0.12) apart = false;
      for (std::size_t j = 0; j < i; ++j) {
        if (distance(balls[i], balls[j]) < 0.067) apart = false;
      }
    }
    if (near < 2 || !apart) continue;
    CornerLayout layout;
    layout.start = {start - origin, 0.0};
    layout.start.heading = 0.69921;  // toward the goal
    layout.goal.position = goal - origin;
    for (Vec2 b : balls) layout.obstacles.push_back({b - origin, 0.0335, {}});
    return layout;
  }
}

/// A scene at the layout's start; views the arguments.
inline NavigationScene sceneOf(const CornerLayout& layout, const FieldGeometry& field,
                               const RobotModel& robot) {
  NavigationScene scene;
  scene.field = &field;
  scene.robot = &robot;
  scene.self.pose = layout.start;
  scene.goal = layout.goal;
  scene.obstacles = layout.obstacles;
  return scene;
}

/// The robot of the comparison (jung-lee-2015) with its top speed set.
inline RobotModel paperRobot(double speed) {
  RobotModel robot;
  robot.wheel_radius = 0.02;
  robot.axle_track = 0.068;
  robot.max_wheel_speed = speed / robot.wheel_radius;
  robot.wheel_acceleration = 5.0;
  robot.wheel_braking = 5.0;
  robot.longitudinal_grip = 10.0;
  robot.lateral_grip = 6.0;
  return robot;
}

}  // namespace fulbito::test
