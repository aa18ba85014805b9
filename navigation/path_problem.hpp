#pragma once

#include <span>
#include <vector>

#include "navigation/circle.hpp"
#include "navigation/scene.hpp"

namespace fulbito {

/// Where and when a moving obstacle is expected to be met: the time [s] after which a robot that drives at
/// `speed` [m/s] straight at it reaches it, at most `horizon` [s].
double meetingTime(const DiscObstacle& obstacle, Vec2 robot, double speed, double horizon);

/// The obstacles as discs at the places where the robot will meet them, with their own radii. An obstacle at
/// rest stays where it is.
void predictObstacles(const NavigationScene& scene, double horizon, std::vector<Circle>& out);

/// Whether a polyline keeps out of discs and walls. A disc that holds the first or last point is shrunk to
/// have it on its edge, as `TangentGraph` does; near an end that is closer to a wall than the margin, the
/// margin is that end's distance.
class PathGuard {
 public:
  /// @param bodies       obstacles without inflation
  /// @param inflation    [m] the robot's radius and the clearance wanted
  /// @param wall_margin  [m]
  void prepare(Vec2 start, Vec2 goal, std::span<const Circle> bodies, double inflation,
               const FieldGeometry& field, double wall_margin);
  bool clear(std::span<const Vec2> path) const;
  /// Whether every point keeps the margin to the walls. True of a set of control points, it is true of their
  /// Bezier curve.
  bool insideWalls(std::span<const Vec2> points) const;
  /// The discs as they are tested.
  std::span<const Circle> discs() const { return discs_; }

 private:
  double margin(Vec2 p) const;

  Vec2 start_, goal_;
  const FieldGeometry* field_ = nullptr;
  double wall_margin_ = 0.0;
  double start_margin_ = 0.0;
  double goal_margin_ = 0.0;
  std::vector<Circle> discs_;
};

/// Distance [m] from `p` to the polyline.
double distanceToPath(std::span<const Vec2> path, Vec2 p);

}  // namespace fulbito
