#pragma once

#include <span>
#include <vector>

#include "experiments/papers/transport/rod_profile.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// The rod and the robots that carry it in the Box2D world.
struct RodWorld {
  RobotModel robot;  ///< model of both robots
  PhysicsProfile physics;
  double mass = 1.0;    ///< [kg] of the rod
  FieldGeometry field;  ///< floor; its origin is at `centre`
  Vec2 centre;          ///< [m] centre of the path's bounding box, in the coordinates of the path
};

/// A floor with room around the path, and a robot of 20 x 20 cm and 2 kg whose wheels reach 0.6 m/s and 1.5
/// m/s^2.
RodWorld rodWorldFor(const TransportTask& task);

/// The controller of one robot. It knows its own pose and reference; the rod acts on it only as a force.
struct PathControl {
  double along = 4.0;    ///< [1/s] speed per error along the heading
  double across = 30.0;  ///< [1/m^2] turn per distance driven and error across
  double heading = 6.0;  ///< [1/s] turn rate per heading error

  /// The twist that follows the reference (Kanayama et al. 1990).
  Twist command(const PartPath& path, const CarrierReference& reference, const Pose2& pose) const;
};

/// Poses of both robots and the rod at a tick, in the coordinates of the path.
struct RodFrame {
  Pose2 lead, follower, rod;
  double force = 0.0;  ///< [N] larger force of both ends
};

/// Measurements of a drive with the real rod.
struct RodDrive {
  double seconds = 0.0;
  double peak_force = 0.0;       ///< [N] largest force of a joint on the rod, averaged over a tick
  double mean_force = 0.0;       ///< [N] root mean square
  double path_error = 0.0;       ///< [m] largest distance of a robot's centre across the path
  double along_error = 0.0;      ///< [m] largest distance of a robot from its place in the reference
  double rod_error = 0.0;        ///< [m] largest difference of the centres' distance from the rod's length
  double end_gap = 0.0;          ///< [m] from the lead to the path's end
  double peak_speed = 0.0;       ///< [m/s] largest speed of a robot's centre
  std::vector<RodFrame> frames;  ///< one per tick
};

/// Drives the references in the world. Errors: as World::create.
Result<RodDrive> driveRod(const TransportTask& task, const RodWorld& world,
                          std::span<const RodReference> references, const PathControl& control = {});

}  // namespace fulbito
