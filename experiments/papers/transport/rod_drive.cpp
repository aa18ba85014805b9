#include "experiments/papers/transport/rod_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito {
namespace {

WorldConfig configOf(const TransportTask& task, const RodWorld& setting) {
  WorldConfig config;
  config.field = setting.field;
  config.physics = setting.physics;
  for (const double q : {task.lead, task.follower}) {
    RobotPlacement robot;
    robot.model = setting.robot;
    robot.pose = task.path.pose(q);
    robot.pose.position -= setting.centre;
    config.robots.push_back(robot);
  }
  config.rods.push_back({1, 0, task.rod, setting.mass});
  return config;
}

/// Drives both robots and records the measurements.
class Driver {
 public:
  Driver(const TransportTask& task, const RodWorld& setting, const PathControl& control, World world)
      : task_(task), setting_(setting), control_(control), world_(std::move(world)) {}

  RodDrive run(std::span<const RodReference> references);

 private:
  Pose2 poseOf(std::size_t robot) const;
  WheelSpeeds commandFor(std::size_t robot, const CarrierReference& reference) const;
  void step(const RodReference& reference);
  void measureRobot(std::size_t robot, const CarrierReference& reference);
  void measure(const RodReference& reference);
  void keepFrame(double force);

  const TransportTask& task_;
  const RodWorld& setting_;
  PathControl control_;
  World world_;
  RodDrive drive_;
  double square_sum_ = 0.0;
};

Pose2 Driver::poseOf(std::size_t robot) const {
  Pose2 pose = world_.state().robots[robot].pose;
  pose.position += setting_.centre;
  return pose;
}

WheelSpeeds Driver::commandFor(std::size_t robot, const CarrierReference& reference) const {
  return inverseKinematics(setting_.robot, control_.command(task_.path, reference, poseOf(robot)));
}

void Driver::measureRobot(std::size_t robot, const CarrierReference& reference) {
  const Vec2 at = poseOf(robot).position;
  const Pose2 on_path = task_.path.pose(task_.path.nearest(at));
  const double beside = std::abs(cross(math::unit(on_path.heading), at - on_path.position));
  const Vec2 wanted = task_.path.pose(reference.place.part, reference.place.q).position;
  drive_.path_error = std::max(drive_.path_error, beside);
  drive_.along_error = std::max(drive_.along_error, distance(at, wanted));
  drive_.peak_speed = std::max(drive_.peak_speed, norm(world_.state().robots[robot].velocity));
}

void Driver::keepFrame(double force) {
  Pose2 rod = world_.state().rods[0].pose;
  rod.position += setting_.centre;
  drive_.frames.push_back({poseOf(0), poseOf(1), rod, force});
}

void Driver::measure(const RodReference& reference) {
  measureRobot(0, reference.lead);
  measureRobot(1, reference.follower);
  const std::array<Vec2, 2>& forces = world_.state().rods[0].forces;
  const double force = std::max(norm(forces[0]), norm(forces[1]));
  const double apart = distance(poseOf(0).position, poseOf(1).position);
  drive_.rod_error = std::max(drive_.rod_error, std::abs(apart - task_.rod));
  drive_.peak_force = std::max(drive_.peak_force, force);
  square_sum_ += (squaredNorm(forces[0]) + squaredNorm(forces[1])) / 2;
  keepFrame(force);
}

void Driver::step(const RodReference& reference) {
  const std::array<WheelSpeeds, 2> commands{commandFor(0, reference.lead), commandFor(1, reference.follower)};
  world_.step(commands);
  measure(reference);
}

RodDrive Driver::run(std::span<const RodReference> references) {
  keepFrame(0.0);
  for (const RodReference& reference : references) step(reference);
  const double period = setting_.physics.controlPeriod();
  const int settling = setting_.physics.control_rate;  // one second to come to rest
  for (int i = 0; i < settling; ++i) step(references.back());
  drive_.seconds = static_cast<double>(references.size()) * period;
  drive_.mean_force = std::sqrt(square_sum_ / static_cast<double>(references.size() + settling));
  drive_.end_gap = distance(poseOf(0).position, task_.path.pose(task_.path.length()).position);
  return std::move(drive_);
}

}  // namespace

RodWorld rodWorldFor(const TransportTask& task) {
  constexpr double kRoom = 0.6;      // [m] around the path
  constexpr double kStride = 0.005;  // [m]
  Vec2 low = task.path.pose(0.0).position, high = low;
  const int count = static_cast<int>(task.path.length() / kStride) + 1;
  for (int i = 0; i <= count; ++i) {
    const Vec2 at = task.path.pose(task.path.length() * i / count).position;
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  RodWorld world;
  world.centre = (low + high) / 2;
  world.field = plainFloor("floor", high.x - low.x + 2 * kRoom, high.y - low.y + 2 * kRoom);
  RobotModel& robot = world.robot;
  robot.name = "carrier";
  robot.length = robot.width = 0.20;
  robot.mass = 2.0;
  robot.wheel_radius = 0.03;
  robot.axle_track = 0.17;
  robot.max_wheel_speed = 20.0;
  robot.wheel_acceleration = robot.wheel_braking = 1.5;
  robot.longitudinal_grip = robot.lateral_grip = 4.0;
  return world;
}

Twist PathControl::command(const PartPath& path, const CarrierReference& reference, const Pose2& pose) const {
  const Pose2 wanted = path.pose(reference.place.part, reference.place.q);
  const Vec2 ahead = math::unit(pose.heading), error = wanted.position - pose.position;
  const math::SinCos turn = math::sinCos(wanted.heading - pose.heading);
  const double curvature = path.parts()[reference.place.part].curvature;
  return {reference.speed * turn.cos + along * dot(ahead, error),
          reference.speed * (curvature + across * cross(ahead, error)) + heading * turn.sin};
}

Result<RodDrive> driveRod(const TransportTask& task, const RodWorld& setting,
                          std::span<const RodReference> references, const PathControl& control) {
  auto world = World::create(configOf(task, setting));
  if (!world) return tl::unexpected<Error>(world.error());
  return Driver(task, setting, control, std::move(*world)).run(references);
}

}  // namespace fulbito
