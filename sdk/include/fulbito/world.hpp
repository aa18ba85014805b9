// The simulated world: walls, robots, balls, obstacles, stepped in control ticks. It knows no rules.
// Component `world`.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// A robot at the start of a world. Robots of both teams share one list; the index identifies a robot.
struct RobotPlacement {
  RobotModel model;               ///< its body and motors
  Pose2 pose;                     ///< pose of its centre
  Vec2 velocity;                  ///< [m/s]
  double angular_velocity = 0.0;  ///< [rad/s]
};

/// A ball at the start of a world.
struct BallPlacement {
  BallModel model;  ///< its rolling and bouncing
  Vec2 position;    ///< [m] its centre
  Vec2 velocity;    ///< [m/s]
  Vec2 spin;        ///< [m/s] as BallState::spin; equal to the velocity of a rolling ball
};

/// A rigid, uniform rod that two robots carry. Each of its ends turns freely about a robot's centre, so the
/// robots stay its length apart. It lies above all bodies and touches none.
struct RodPlacement {
  std::size_t first = 0;   ///< index of the robot at its rear end
  std::size_t second = 1;  ///< index of the robot at its front end
  double length = 0.8;     ///< [m] between the robots' centres; they start that far apart, within 1 mm
  double mass = 0.5;       ///< [kg]
};

/// The complete configuration of a world. Two worlds with equal configurations and equal commands stay equal,
/// bit for bit.
struct WorldConfig {
  FieldGeometry field;                  ///< walls and goals
  PhysicsProfile physics;               ///< control rate, sub-steps, solver
  std::vector<RobotPlacement> robots;   ///< robots of both teams; commands and states have this order
  std::vector<BallPlacement> balls;     ///< any number, usually one
  std::vector<ObstacleSpec> obstacles;  ///< obstacles of a navigation trial; none in a match
  std::vector<RodPlacement> rods = {};  ///< rods that pairs of robots carry; none in a match
};

/// A fixed-step rigid-body world: walls, goals, corner triangles, robots, balls and obstacles.
/// To reset it, create a new one. Single-threaded; separate worlds may run on separate threads.
class World {
 public:
  /// Creates the world. Positions must be inside the field. Bodies may overlap: the engine pushes them apart.
  /// Errors: kBadInput naming the robot, ball, obstacle or rod (counted from 0), the value and its range.
  static Result<World> create(const WorldConfig& config);
  /// A moved-from world can only be destroyed or assigned to.
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// Runs one control tick. In commands NaN becomes 0; then they are clamped and rounded to the profile's
  /// step. Robots beyond the end of `commands` get 0: their wheels brake. Allocates nothing once warm.
  void step(std::span<const WheelSpeeds> commands);

  /// State after the last tick.
  const WorldState& state() const;
  /// Contacts of the last tick.
  std::span<const ContactEvent> contacts() const;
  /// The configuration given to `create`.
  const WorldConfig& config() const;

  /// Box2D's measured duration of the last step [ms]: 0 proves that the library replaces its profiling clock.
  float engineProfileMilliseconds() const;
  /// Number of touching contact pairs after the last tick, for comparisons of load.
  int touchingPairs() const;

 private:
  struct Impl;
  explicit World(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
