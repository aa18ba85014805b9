#include "navigation/library/plugin_values.hpp"

#include <cstring>

#include "engine/core/system/error_text.hpp"

namespace fulbito {

void copyName(std::string_view text, char (&to)[FULBITO_NAME_SIZE]) {
  const std::string_view kept = firstBytes(text, FULBITO_NAME_SIZE - 1);
  std::memset(to, 0, sizeof to);
  if (!kept.empty()) std::memcpy(to, kept.data(), kept.size());  // an empty view may have no text
}

fulbito_robot toAbi(const RobotState& robot) {
  return {1,
          0,
          toAbi(robot.pose.position),
          robot.pose.heading,
          toAbi(robot.velocity),
          robot.angular_velocity,
          toAbi(robot.wheels)};
}

fulbito_field toAbi(const FieldGeometry& field) {
  fulbito_field to{};
  copyName(field.name, to.name);
  to.length = field.length;
  to.width = field.width;
  to.goal_width = field.goal_width;
  to.goal_depth = field.goal_depth;
  to.corner = field.corner;
  to.wall_thickness = field.wall_thickness;
  to.goal_area_width = field.goal_area_width;
  to.goal_area_depth = field.goal_area_depth;
  to.goal_area_arc_width = field.goal_area_arc_width;
  to.goal_area_arc_depth = field.goal_area_arc_depth;
  to.big_area_width = field.big_area_width;
  to.big_area_depth = field.big_area_depth;
  to.centre_circle_radius = field.centre_circle_radius;
  to.penalty_mark = field.penalty_mark;
  to.free_ball_mark = toAbi(field.free_ball_mark);
  return to;
}

fulbito_robot_model toAbi(const RobotModel& robot) {
  fulbito_robot_model to{};
  copyName(robot.name, to.name);
  to.length = robot.length;
  to.width = robot.width;
  to.mass = robot.mass;
  to.wheel_radius = robot.wheel_radius;
  to.axle_track = robot.axle_track;
  to.max_wheel_speed = robot.max_wheel_speed;
  to.wheel_acceleration = robot.wheel_acceleration;
  to.wheel_braking = robot.wheel_braking;
  to.yaw_acceleration = robot.yaw_acceleration;
  to.rolling_drag = robot.rolling_drag;
  to.longitudinal_grip = robot.longitudinal_grip;
  to.lateral_grip = robot.lateral_grip;
  to.spin_slow_speed = robot.spin_slow_speed;
  to.spin_slow_ratio = robot.spin_slow_ratio;
  to.spin_fast_speed = robot.spin_fast_speed;
  to.spin_fast_ratio = robot.spin_fast_ratio;
  to.friction = robot.friction;
  to.restitution = robot.restitution;
  return to;
}

fulbito_curve_widening wideningToAbi(const RobotModel& robot) {
  return {robot.curve_widening, robot.curve_widening_rise};
}

}  // namespace fulbito
