#pragma once

#include <span>
#include <vector>

#include "fulbito/navigation.hpp"
#include "navigation/geometry/circle.hpp"

namespace fulbito {

/// Whether an obstacle is faster than 5 mm/s. (The limit of `forecast` is 3 cm/s, since its plans are refined
/// over many ticks and should survive a slow drift.)
bool isMoving(const DiscObstacle& obstacle);

/// The time [s] after which a robot that drives at `speed` [m/s] straight toward the obstacle meets it, at
/// most `horizon` [s].
double meetingTime(const DiscObstacle& obstacle, Vec2 robot, double speed, double horizon);

/// The obstacles as discs with their own radii, at the places where the robot will meet them. An obstacle at
/// rest stays where it is.
void predictObstacles(const NavigationScene& scene, double horizon, std::vector<Circle>& out);

/// Tests whether a polyline keeps away from discs and walls.
///
/// Near its ends a path may have to come closer than wanted. If the start or the goal is within the clearance
/// of a disc, the clearance there shrinks by up to 1 cm more. The robot's circumscribed circle stays free. A
/// disc that still holds the point is shrunk until the point is on its edge. Within 10 cm of an end that is
/// closer to a wall than the margin, the margin is that end's distance.
class PathGuard {
 public:
  /// @param bodies        obstacles without inflation
  /// @param robot_radius  [m] circumscribed circle; also the margin to the walls
  /// @param clearance     [m] wanted gap between that circle and the obstacles
  void prepare(Vec2 start, Vec2 goal, std::span<const Circle> bodies, double robot_radius, double clearance,
               const FieldGeometry& field);
  bool clear(std::span<const Vec2> path) const;
  /// Whether a point is outside all discs.
  bool clearAt(Vec2 p) const;
  /// Whether every point keeps the margin to the walls. If this holds for control points, it holds for their
  /// Bezier curve.
  bool insideWalls(std::span<const Vec2> points) const;

 private:
  double margin(Vec2 p) const;

  Vec2 start_, goal_;
  const FieldGeometry* field_ = nullptr;
  double wall_margin_ = 0.0;
  double start_margin_ = 0.0;
  double goal_margin_ = 0.0;
  std::vector<Circle> discs_;
};

}  // namespace fulbito
