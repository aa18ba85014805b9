#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The shape of an obstacle from above.
enum class ObstacleShape { kDisc, kBox };
/// The motion of an obstacle: none, along its path without regard for other bodies, or only when pushed.
enum class ObstacleMotion { kFixed, kPath, kPushable };
/// Behaviour of a moving obstacle at the end of its path.
enum class PathEnd { kBounce, kCycle, kStop };

/// One obstacle of a layout.
struct ObstacleSpec {
  ObstacleShape shape = ObstacleShape::kDisc;      ///< selects the sizes below
  ObstacleMotion motion = ObstacleMotion::kFixed;  ///< its kind of motion
  Pose2 pose;                                      ///< start pose; with a path, at its first waypoint
  double radius = 0.0335;                          ///< [m] of a disc: a tennis ball
  double length = 0.075;                           ///< [m] of a box along its x
  double width = 0.075;                            ///< [m] of a box along its y
  double mass = 0.058;                             ///< [kg] when pushable
  double floor_friction = 0.5;                     ///< [m/s^2] deceleration on the floor when pushable
  std::vector<Vec2> path;                          ///< [m] waypoints when moving on a path, at least 2
  double speed = 0.3;                              ///< [m/s] along the path
  PathEnd path_end = PathEnd::kBounce;             ///< its behaviour at the last waypoint
};

/// Position of an obstacle after `time` [s]; `pose.position` if it does not follow a path. For negative
/// times, a path that stops stays at its start; the others are periodic.
Vec2 positionAt(const ObstacleSpec& obstacle, double time);
/// Velocity [m/s] of an obstacle after `time` [s]; at a waypoint, that of the segment that begins there.
Vec2 velocityAt(const ObstacleSpec& obstacle, double time);

/// A navigation problem: one robot from `start` to `goal` among obstacles on a field.
struct Layout {
  std::string name = "layout";          ///< for tables and pictures
  std::string field = "vsss-3v3";       ///< preset name or file
  Pose2 start;                          ///< pose of the robot at the start
  Vec2 goal;                            ///< [m] target of the robot's centre
  std::optional<double> goal_heading;   ///< [rad] on arrival; empty: any
  double goal_tolerance = 0.03;         ///< [m] distance that counts as arrival
  double heading_tolerance = 0.1745;    ///< [rad] tolerance of the heading on arrival
  std::vector<ObstacleSpec> obstacles;  ///< at most 500
};

/// Checks ranges and consistency; the error names the key.
Result<void> validate(const Layout& layout);
/// Also checks that start, goal and obstacle positions lie inside the field.
Result<void> validate(const Layout& layout, const FieldGeometry& field);

}  // namespace fulbito
