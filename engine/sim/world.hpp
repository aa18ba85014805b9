#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/base/contact.hpp"
#include "engine/core/base/result.hpp"
#include "engine/core/base/values.hpp"
#include "engine/core/models/ball_model.hpp"
#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/layout.hpp"
#include "engine/core/models/physics_profile.hpp"
#include "engine/core/models/robot_model.hpp"

namespace fulbito {

/// A robot at the start of a world. Robots of both teams share one list; the index identifies a robot.
struct RobotPlacement {
  RobotModel model;
  Pose2 pose;
  Vec2 velocity;                  ///< [m/s]
  double angular_velocity = 0.0;  ///< [rad/s]
};

/// A ball at the start of a world.
struct BallPlacement {
  BallModel model;
  Vec2 position;
  Vec2 velocity;  ///< [m/s]
  Vec2 spin;      ///< [m/s] as in BallState; equal to the velocity when the ball rolls
};

/// The complete configuration of a world. Two worlds with equal configurations and equal commands stay equal,
/// bit for bit.
struct WorldConfig {
  FieldGeometry field;
  PhysicsProfile physics;
  std::vector<RobotPlacement> robots;
  std::vector<BallPlacement> balls;
  std::vector<ObstacleSpec> obstacles;
};

/// A fixed-step rigid-body world: walls, goals, corner triangles, robots, balls and obstacles.
/// To reset it, create a new one. Single-threaded; separate worlds may run on separate threads.
class World {
 public:
  /// Errors: kBadInput naming the robot, ball or obstacle (counted from 0), the value and its range;
  /// positions must be inside the field. Bodies may overlap: the engine pushes them apart.
  static Result<World> create(const WorldConfig& config);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// Runs one control tick. In commands NaN becomes 0, then they are clamped and rounded to the profile's
  /// step. Robots beyond the end of `commands` get 0: their wheels brake. Allocates nothing once warm.
  void step(std::span<const WheelSpeeds> commands);

  /// State after the last tick.
  const WorldState& state() const;
  /// Contacts of the last tick.
  std::span<const ContactEvent> contacts() const;
  const WorldConfig& config() const;

  /// Box2D's measurement of the last step's duration [ms]: 0 proves that its profiling clock is replaced.
  float engineProfileMilliseconds() const;
  /// Number of touching contact pairs after the last tick (for comparing loads).
  int touchingPairs() const;

 private:
  struct Impl;
  explicit World(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
