#include "engine/core/models/drive_law.hpp"
#include "engine/core/system/text_file.hpp"
#include "fulbito/report.hpp"

namespace fulbito {

FieldGeometry plainFloor(const std::string& name, double length, double width) {
  FieldGeometry field;
  field.name = name;
  field.length = length;
  field.width = width;
  field.goal_width = field.goal_depth = field.corner = 0.0;
  field.goal_area_width = field.goal_area_depth = field.goal_area_arc_width = field.goal_area_arc_depth = 0.0;
  field.centre_circle_radius = field.penalty_mark = 0.0;
  field.free_ball_mark = {};
  return field;
}

WheelSpeeds wheelsOverGround(const RobotModel& robot, Twist twist) {
  const double turn = twist.angular * robot.axle_track / 2;
  const DriveLaw law(robot, 1.0);  // slip does not depend on the time step
  const RimSpeeds rims = law.commandFor({twist.linear - turn, twist.linear + turn});
  return saturate(robot, {rims.left / robot.wheel_radius, rims.right / robot.wheel_radius});
}

Result<std::string> readSettingFile(const std::string& file, std::size_t max_bytes) {
  return readTextFile(file, max_bytes);
}

}  // namespace fulbito
