#include "experiments/capture/hall.hpp"

#include "fulbito/detail/math.hpp"

namespace fulbito::capture {

FieldGeometry hall() {
  FieldGeometry field;
  field.name = "hall";
  field.length = field.width = 20.0;
  field.goal_width = field.goal_depth = field.corner = 0.0;
  field.goal_area_width = field.goal_area_depth = field.goal_area_arc_width = field.goal_area_arc_depth = 0.0;
  field.centre_circle_radius = field.penalty_mark = 0.0;
  field.free_ball_mark = {};
  return field;
}

PhysicsProfile hallPhysics() {
  PhysicsProfile physics;
  physics.wheel_command_step = 0.0;
  return physics;
}

RobotModel objectModel() {
  RobotModel model;
  model.name = "object";
  model.length = 0.246, model.width = 0.191, model.mass = 0.95;
  model.wheel_radius = 0.019, model.axle_track = 0.184;
  model.max_wheel_speed = 50.0;
  return model;
}

RobotPlacement placed(const RobotModel& model, const Pose2& pose, double speed) {
  RobotPlacement placement;
  placement.model = model;
  placement.pose = pose;
  placement.velocity = math::unit(pose.heading) * speed;
  return placement;
}

}  // namespace fulbito::capture
