#pragma once

#include <span>
#include <vector>

#include "fulbito/navigation.hpp"
#include "navigation/geometry/circle.hpp"

namespace fulbito {

/// Whether an obstacle is faster than 5 mm/s. (`forecast` asks for 3 cm/s: a plan that is refined over many
/// ticks loses more by being made anew than by such a drift.)
bool isMoving(const DiscObstacle& obstacle);

/// Where and when a moving obstacle is expected to be met: the time [s] after which a robot that drives at
/// `speed` [m/s] straight at it reaches it, at most `horizon` [s].
double meetingTime(const DiscObstacle& obstacle, Vec2 robot, double speed, double horizon);

/// The obstacles as discs at the places where the robot will meet them, with their own radii. An obstacle at
/// rest stays where it is.
void predictObstacles(const NavigationScene& scene, double horizon, std::vector<Circle>& out);

/// Whether a polyline keeps out of discs and walls.
///
/// Near its ends it may have to come closer than wanted: where the start or the goal is within the clearance
/// of a disc, up to 1 cm of clearance more is given up there, but not the robot's circumscribed circle; a
/// disc that holds the point even so is shrunk until the point is on its edge. Within 10 cm of an end that is
/// closer to a wall than the margin, the margin is that end's distance.
class PathGuard {
 public:
  /// @param bodies        obstacles without inflation
  /// @param robot_radius  [m] circumscribed circle, also kept from the walls
  /// @param clearance     [m] wanted between that circle and the obstacles
  void prepare(Vec2 start, Vec2 goal, std::span<const Circle> bodies, double robot_radius, double clearance,
               const FieldGeometry& field);
  bool clear(std::span<const Vec2> path) const;
  /// Whether a point is outside of all discs.
  bool clearAt(Vec2 p) const;
  /// Whether every point keeps the margin to the walls. True of a set of control points, it is true of their
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
