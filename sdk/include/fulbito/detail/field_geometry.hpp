#pragma once

#include <string>
#include <vector>

#include "fulbito/detail/values.hpp"
#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// A straight piece of wall. The field is on the left when going from `a` to `b`.
struct WallSegment {
  Vec2 a;  ///< [m] its start
  Vec2 b;  ///< [m] its end
};

/// Rectangular field with optional goals and corner triangles. World frame: centre, x along the length.
/// Defaults: the 3v3 field of the IEEE VSSS rules.
struct FieldGeometry {
  std::string name = "vsss-3v3";       ///< name of the preset
  double length = 1.50;                ///< [m] x extent, 0.3 ... 20
  double width = 1.30;                 ///< [m] y extent, 0.3 ... 20
  double goal_width = 0.40;            ///< [m] y extent of the mouth; 0: no goals
  double goal_depth = 0.10;            ///< [m] behind the goal line
  double corner = 0.07;                ///< [m] legs of the corner triangles; 0: square corners
  double wall_thickness = 0.05;        ///< [m] thickness of the simulated walls
  double goal_area_width = 0.70;       ///< [m] y extent
  double goal_area_depth = 0.15;       ///< [m] x extent
  double goal_area_arc_width = 0.20;   ///< [m] chord of the arc in front of the goal area; 0: no arc
  double goal_area_arc_depth = 0.05;   ///< [m] depth of the arc beyond the area's front line
  double big_area_width = 0.0;         ///< [m] y extent of the larger games' penalty area; 0: none
  double big_area_depth = 0.0;         ///< [m] its x extent
  double centre_circle_radius = 0.20;  ///< [m]
  double penalty_mark = 0.375;         ///< [m] distance from the centre along x; 0: not drawn
  Vec2 free_ball_mark{0.375, 0.40};    ///< [m] in the first quadrant, the other three mirrored; 0: none

  /// Whether there are goals that a ball can enter.
  bool hasGoals() const { return goal_width > 0.0 && goal_depth > 0.0; }
};

/// A rectangular floor between four walls: no goals, no corner triangles, no marks of soccer.
/// @param length, width  [m]
FieldGeometry plainFloor(const std::string& name, double length, double width);

/// The closed inner contour, counter-clockwise, goals included: N points, the last joins the first.
std::vector<Vec2> innerContour(const FieldGeometry& field);

/// Signed distance [m] from `p` to the nearest wall of the playing rectangle with its corner triangles; goals
/// do not count. It is positive on the field. Outside, it is minus the distance to the wall that `p` is
/// farthest behind. Minus infinity if `p` is not finite. Planners that stay on the field use it.
double wallClearance(const FieldGeometry& field, Vec2 p);

/// The wall nearest to `p` in the sense of `wallClearance`: its unit normal pointing into the field.
Vec2 nearestWallNormal(const FieldGeometry& field, Vec2 p);

/// Whether `p` lies inside the contour, goals included, with a margin [m] (negative margin: a tolerance
/// outside). False if `p` is not finite.
bool insideField(const FieldGeometry& field, Vec2 p, double margin = 0.0);

/// Checks ranges and consistency; the error names the key.
Result<void> validate(const FieldGeometry& field);

}  // namespace fulbito
