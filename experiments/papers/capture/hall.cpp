#include "experiments/papers/capture/hall.hpp"

#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {

FieldGeometry hall() { return plainFloor("hall", 20.0, 20.0); }

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
