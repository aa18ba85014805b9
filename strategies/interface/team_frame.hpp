#pragma once

#include "fulbito/detail/math.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/referee.hpp"

/// A team's frame: its own goal is at -x. For the team that defends the left goal it is the world frame. For
/// the other team it is the world frame rotated by 180 degrees, never reflected, which would swap the wheels.
/// The rotation is its own inverse, and exact except for the rounding of the heading.
namespace fulbito {

constexpr Vec2 inTeamFrame(Side own_side, Vec2 v) { return own_side == Side::kLeft ? v : -v; }

inline Pose2 inTeamFrame(Side own_side, const Pose2& pose) {
  if (own_side == Side::kLeft) return pose;
  return {-pose.position, math::wrapAngle(pose.heading + math::kPi)};
}

inline RobotState inTeamFrame(Side own_side, RobotState robot) {
  robot.pose = inTeamFrame(own_side, robot.pose);
  robot.velocity = inTeamFrame(own_side, robot.velocity);
  return robot;
}

inline BallState inTeamFrame(Side own_side, const BallState& ball) {
  return {inTeamFrame(own_side, ball.position), inTeamFrame(own_side, ball.velocity),
          inTeamFrame(own_side, ball.spin)};
}

inline GameEvent inTeamFrame(Side own_side, GameEvent event) {
  event.place = inTeamFrame(own_side, event.place);
  return event;
}

}  // namespace fulbito
