#pragma once

#include "fulbito/strategy.hpp"

/// Mirrors what a team sees and commands across the long axis of the field: left and right change places.
namespace fulbito {

inline Vec2 mirrored(Vec2 v) { return {v.x, -v.y}; }

inline Pose2 mirrored(const Pose2& pose) { return {mirrored(pose.position), -pose.heading}; }

inline WheelSpeeds mirrored(WheelSpeeds wheels) { return {wheels.right, wheels.left}; }

inline RobotState mirrored(RobotState robot) {
  robot.pose = mirrored(robot.pose);
  robot.velocity = mirrored(robot.velocity);
  robot.angular_velocity = -robot.angular_velocity;
  robot.wheels = mirrored(robot.wheels);
  return robot;
}

inline Observation mirrored(Observation seen) {
  for (ObservedRobot& robot : seen.own) robot.state = mirrored(robot.state);
  for (ObservedRobot& robot : seen.opponents) robot.state = mirrored(robot.state);
  seen.ball = {mirrored(seen.ball.position), mirrored(seen.ball.velocity), mirrored(seen.ball.spin)};
  for (WheelSpeeds& wheels : seen.sent) wheels = mirrored(wheels);
  return seen;
}

inline TeamPlacement mirrored(TeamPlacement poses) {
  for (auto& pose : poses) {
    if (pose) pose = mirrored(*pose);
  }
  return poses;
}

inline PlacementRequest mirrored(PlacementRequest request) {
  request.ball = mirrored(request.ball);
  request.defaults = mirrored(request.defaults);
  if (request.opponents) request.opponents = mirrored(*request.opponents);
  request.cause.place = mirrored(request.cause.place);
  request.now = mirrored(request.now);
  return request;
}

inline PlayStop mirrored(PlayStop stop) {
  stop.cause.place = mirrored(stop.cause.place);
  stop.now = mirrored(stop.now);
  return stop;
}

inline RobotCommand mirrored(RobotCommand robot) {
  robot.wheels = mirrored(robot.wheels);
  robot.twist.angular = -robot.twist.angular;
  robot.go_to.position = mirrored(robot.go_to.position);
  if (robot.go_to.heading) robot.go_to.heading = -*robot.go_to.heading;
  return robot;
}

}  // namespace fulbito
