#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "fulbito/detail/math.hpp"
#include "fulbito/world.hpp"
#include "tests/support/robot_presets.hpp"

namespace fulbito::test {

/// Makes the world or ends the program with the reason: for configurations that are right by construction.
inline World makeWorld(const WorldConfig& config) {
  Result<World> world = World::create(config);
  if (!world) throw std::runtime_error(world.error().message);
  return std::move(*world);
}

/// The same physics steps, but the state can be read after each.
inline PhysicsProfile readEachStep(PhysicsProfile physics) {
  physics.control_rate *= physics.substeps;
  physics.substeps = 1;
  return physics;
}

/// A wide field without goals and corners, where nothing is in the way.
inline FieldGeometry wideField() {
  return {.name = "wide", .length = 16.0, .width = 16.0, .goal_width = 0.0, .goal_depth = 0.0, .corner = 0.0};
}

/// One robot at the origin of a wide field, heading along +x.
inline WorldConfig loneRobot(const RobotModel& robot, const PhysicsProfile& physics) {
  WorldConfig config{wideField(), physics, {}, {}, {}};
  config.robots.push_back({robot, {}, {}, 0.0});
  return config;
}

/// One ball rolling or sliding from the origin along +x.
inline WorldConfig loneBall(const BallModel& ball, const PhysicsProfile& physics, Vec2 velocity, Vec2 spin) {
  WorldConfig config{wideField(), physics, {}, {}, {}};
  config.balls.push_back({ball, {}, velocity, spin});
  return config;
}

/// A disc the size of a tennis ball.
inline ObstacleSpec discAt(Vec2 position, ObstacleMotion motion = ObstacleMotion::kFixed) {
  ObstacleSpec disc;
  disc.motion = motion;
  disc.pose.position = position;
  return disc;
}

/// Two teams of `per_team` robots facing each other in two columns, a ball in the middle.
inline WorldConfig matchConfig(const RobotPreset& preset, const PhysicsProfile& physics, int per_team,
                               const FieldGeometry& field) {
  WorldConfig config{field, physics, {}, {}, {}};
  for (int team = 0; team < 2; ++team) {
    const double side = team == 0 ? -1.0 : 1.0;
    for (int i = 0; i < per_team; ++i) {
      const double y = (i - (per_team - 1) / 2.0) * field.width / (per_team + 1);
      // A half turn of the field maps one team onto the other.
      config.robots.push_back(
          {preset.robot, {{side * field.length / 4, -side * y}, team == 0 ? 0.0 : -math::kPi}, {}, 0.0});
    }
  }
  config.balls.push_back({preset.ball, {}, {}, {}});
  return config;
}

inline FieldGeometry largeField() {
  return {.name = "vsss-5v5", .length = 2.2, .width = 1.8, .goal_width = 0.4, .goal_depth = 0.15};
}

/// Wheel speeds of a robot that always drives at the target, forward or backward, and never stops pushing.
inline WheelSpeeds chase(const RobotState& robot, Vec2 target) {
  const Vec2 ahead = math::unit(robot.pose.heading), to = unitOr(target - robot.pose.position, ahead);
  const double along = dot(ahead, to) >= 0.0 ? 35.0 : -35.0;
  const double turn = 20.0 * cross(ahead, to) * (along > 0.0 ? 1.0 : -1.0);
  return {along - turn, along + turn};
}

/// The same wheel speeds for every robot, `ticks` times.
inline void run(World& world, WheelSpeeds wheels, int ticks) {
  const std::vector<WheelSpeeds> commands(world.config().robots.size(), wheels);
  for (int i = 0; i < ticks; ++i) world.step(commands);
}

}  // namespace fulbito::test
