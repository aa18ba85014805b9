#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/math.hpp"
#include "navigation/pilot.hpp"

namespace fulbito::test {

/// Outcome of a trial with the kinematic robot below.
struct KinematicResult {
  bool reached = false;
  bool touched = false;        ///< the robot's square overlapped an obstacle or left the field
  double time = 0.0;           ///< [s]
  double length = 0.0;         ///< [m]
  double min_clearance = 1e9;  ///< [m] of the square to obstacles and walls
  double final_heading = 0.0;  ///< [rad]
  std::vector<Vec2> path;
};

/// Distance [m] from a disc to the robot's rectangle, negative when they overlap.
inline double bodyClearance(const RobotModel& robot, const Pose2& pose, Vec2 centre, double radius) {
  const Vec2 ux = math::unit(pose.heading), d = centre - pose.position;
  const double x = std::abs(dot(d, ux)) - robot.length / 2, y = std::abs(cross(ux, d)) - robot.width / 2;
  const double outside = norm({std::max(x, 0.0), std::max(y, 0.0)});
  return (outside > 0.0 ? outside : std::max(x, y)) - radius;
}

/// Clearance of the robot's corners to the field's walls.
inline double bodyWallClearance(const RobotModel& robot, const Pose2& pose, const FieldGeometry& field) {
  const Vec2 ux = math::unit(pose.heading) * (robot.length / 2),
             uy = perp(math::unit(pose.heading)) * (robot.width / 2);
  double least = 1e9;
  for (Vec2 c : {ux + uy, ux - uy, -ux + uy, -ux - uy})
    least = std::min(least, wallClearance(field, pose.position + c));
  return least;
}

/// Drives `pilot` from `start` with an ideal robot: wheels follow commands within the wheel acceleration,
/// sideways slip dies by Coulomb grip, 1 ms steps, 60 Hz control. No contacts: an overlap is only recorded.
/// For tests without the physics world.
inline KinematicResult kinematicTrial(Pilot& pilot, const RobotModel& robot, const FieldGeometry& field,
                                      Pose2 start, const NavigationGoal& goal,
                                      std::vector<DiscObstacle> obstacles, double time_limit = 15.0) {
  KinematicResult result;
  pilot.reset();
  NavigationScene scene;
  scene.field = &field;
  scene.robot = &robot;
  scene.goal = goal;
  scene.self.pose = start;
  double left = 0.0, right = 0.0;  // rim speeds
  Vec2 velocity{};
  const double h = 1e-3;
  const int ticks = static_cast<int>(time_limit * 60.0);
  for (int tick = 0; tick < ticks; ++tick) {
    scene.tick = tick;
    scene.obstacles = obstacles;
    const WheelSpeeds wheels = pilot.drive(scene);
    const int steps = tick % 3 == 0 ? 16 : 17;  // 60 Hz in whole milliseconds on average
    for (int i = 0; i < steps; ++i) {
      Pose2& pose = scene.self.pose;
      const double change = robot.wheel_acceleration * h;
      left += std::clamp(wheels.left * robot.wheel_radius - left, -change, change);
      right += std::clamp(wheels.right * robot.wheel_radius - right, -change, change);
      const double forward = (left + right) / 2;
      scene.self.angular_velocity = (right - left) / robot.axle_track;
      pose.heading = math::wrapAngle(pose.heading + scene.self.angular_velocity * h);
      const Vec2 ux = math::unit(pose.heading);
      double side = cross(ux, velocity);
      side -= std::clamp(side, -robot.lateral_grip * h, robot.lateral_grip * h);
      velocity = ux * forward + perp(ux) * side;
      pose.position += velocity * h;
      result.length += norm(velocity) * h;
      for (DiscObstacle& o : obstacles) o.position += o.velocity * h;
      result.time += h;
      if (distance(pose.position, goal.position) <= goal.tolerance &&
          (!goal.heading ||
           std::abs(math::wrapAngle(pose.heading - *goal.heading)) <= goal.heading_tolerance)) {
        result.reached = true;
        break;
      }
    }
    scene.self.velocity = velocity;
    scene.self.wheels = {left / robot.wheel_radius, right / robot.wheel_radius};
    for (const DiscObstacle& o : obstacles) {
      result.min_clearance =
          std::min(result.min_clearance, bodyClearance(robot, scene.self.pose, o.position, o.radius));
    }
    result.min_clearance = std::min(result.min_clearance, bodyWallClearance(robot, scene.self.pose, field));
    result.path.push_back(scene.self.pose.position);
    if (result.reached) break;
  }
  result.touched = result.min_clearance < 0.0;
  result.final_heading = scene.self.pose.heading;
  return result;
}

}  // namespace fulbito::test
