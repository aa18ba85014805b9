#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "engine/core/models/drive_law.hpp"
#include "engine/core/models/shapes.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/navigation.hpp"

namespace fulbito::test {

/// Outcome of a trial with the kinematic robot below.
struct KinematicResult {
  bool reached = false;
  bool touched = false;    ///< the robot's square overlapped an obstacle or left the field
  double time = 0.0;       ///< [s]
  double length = 0.0;     ///< [m]
  bool own_fault = false;  ///< at the first overlap with an obstacle the robot drove at it faster than 2 cm/s
  double min_clearance = 1e9;  ///< [m] of the square to obstacles and walls
  double final_heading = 0.0;  ///< [rad]
  std::vector<Vec2> path;
  std::vector<double> tick_micros;  ///< [us] wall time of each `drive`, to print; nothing depends on it
};

/// Clearance of the robot's corners to the field's walls.
inline double bodyWallClearance(const RobotModel& robot, const Pose2& pose, const FieldGeometry& field) {
  const Vec2 ux = math::unit(pose.heading) * (robot.length / 2),
             uy = perp(math::unit(pose.heading)) * (robot.width / 2);
  double least = 1e9;
  for (Vec2 c : {ux + uy, ux - uy, -ux + uy, -ux - uy})
    least = std::min(least, wallClearance(field, pose.position + c));
  return least;
}

/// Moves a disc on, bouncing off the playing rectangle's walls.
inline void moveDisc(DiscObstacle& o, const FieldGeometry& field, double h) {
  o.position += o.velocity * h;
  if (std::abs(o.position.x) > field.length / 2 - o.radius && o.position.x * o.velocity.x > 0.0)
    o.velocity.x = -o.velocity.x;
  if (std::abs(o.position.y) > field.width / 2 - o.radius && o.position.y * o.velocity.y > 0.0)
    o.velocity.y = -o.velocity.y;
}

/// Ideal robot: the wheels follow commands by the drive's law, and Coulomb friction pulls the
/// body's velocity to that of the wheels, along and across them within an ellipse of the two grips. The
/// velocity never overshoots the wheels', so that no turn makes the robot faster than both were.
struct KinematicRobot {
  RobotState state;
  double left = 0.0, right = 0.0;  ///< [m/s] of the rims

  void step(const RobotModel& robot, WheelSpeeds wheels, double h) {
    const DriveLaw law(robot, h);
    const RimSpeeds rims{left, right},
        target{wheels.left * robot.wheel_radius, wheels.right * robot.wheel_radius};
    const RimSpeeds change = law.change(rims, law.pulls(rims, target, {law.limit(), law.limit()}));
    left += change.left;
    right += change.right;
    state.angular_velocity = (right - left) / robot.axle_track;
    state.pose.heading = math::wrapAngle(state.pose.heading + state.angular_velocity * h);
    const Vec2 ux = math::unit(state.pose.heading);
    const Vec2 slip = ux * ((left + right) / 2) - state.velocity;
    const double along = dot(ux, slip) / robot.longitudinal_grip,
                 across = cross(ux, slip) / robot.lateral_grip;
    const double needed = norm({along, across});  // [s] of all the grip
    state.velocity += slip * (needed > h ? h / needed : 1.0);
    state.pose.position += state.velocity * h;
    state.wheels = {left / robot.wheel_radius, right / robot.wheel_radius};
  }
};

/// Keeps the least clearance, and whether the robot drove into what it first overlapped.
inline void noteClearance(const RobotState& state, const RobotModel& robot, const FieldGeometry& field,
                          const std::vector<DiscObstacle>& obstacles, KinematicResult& result) {
  const Pose2& pose = state.pose;
  for (const DiscObstacle& o : obstacles) {
    const double gap = clearance(bodyOf(robot, pose), o.position, o.radius);
    if (gap < 0.0 && result.min_clearance >= 0.0) {
      const Vec2 toward = unitOr(o.position - pose.position, {});
      result.own_fault = dot(state.velocity, toward) > 0.02;
    }
    result.min_clearance = std::min(result.min_clearance, gap);
  }
  result.min_clearance = std::min(result.min_clearance, bodyWallClearance(robot, pose, field));
}

/// Drives `pilot` from `start` with a KinematicRobot in 1 ms steps, 60 Hz control. No contacts: an overlap is
/// only recorded. For tests without the physics world.
inline KinematicResult kinematicTrial(Pilot& pilot, const RobotModel& robot, const FieldGeometry& field,
                                      Pose2 start, const NavigationGoal& goal,
                                      std::vector<DiscObstacle> obstacles, double time_limit = 15.0) {
  KinematicResult result;
  pilot.reset();
  NavigationScene scene;
  scene.field = &field;
  scene.robot = &robot;
  scene.goal = goal;
  KinematicRobot body;
  body.state.pose = start;
  const double h = 1e-3;
  const int ticks = static_cast<int>(time_limit * 60.0);
  for (int tick = 0; tick < ticks; ++tick) {
    scene.tick = tick;
    scene.obstacles = obstacles;
    scene.self = body.state;
    const auto begin = std::chrono::steady_clock::now();
    const WheelSpeeds wheels = pilot.drive(scene);
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
    result.tick_micros.push_back(spent.count());
    const int steps = tick % 3 == 0 ? 16 : 17;  // 60 Hz in whole milliseconds on average
    for (int i = 0; i < steps; ++i) {
      body.step(robot, wheels, h);
      const Pose2& pose = body.state.pose;
      result.length += norm(body.state.velocity) * h;
      for (DiscObstacle& o : obstacles) moveDisc(o, field, h);
      result.time += h;
      if (distance(pose.position, goal.position) <= goal.tolerance &&
          (!goal.heading ||
           std::abs(math::wrapAngle(pose.heading - *goal.heading)) <= goal.heading_tolerance)) {
        result.reached = true;
        break;
      }
    }
    noteClearance(body.state, robot, field, obstacles, result);
    result.path.push_back(body.state.pose.position);
    if (result.reached) break;
  }
  result.touched = result.min_clearance < 0.0;
  result.final_heading = body.state.pose.heading;
  return result;
}

}  // namespace fulbito::test
