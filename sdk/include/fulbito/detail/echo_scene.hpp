#pragma once

#include <limits>
#include <span>
#include <vector>

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// A cone in the plane, e.g. the field of hearing of a sonar.
struct Cone {
  Vec2 apex;                ///< [m]
  Vec2 axis{1.0, 0.0};      ///< unit
  double half_angle = 0.0;  ///< [rad] below pi / 2
  double reach = 1.0;       ///< [m]
};

/// The first surface on a ray.
struct RayHit {
  double distance = std::numeric_limits<double>::infinity();  ///< [m] infinity: nothing within the range
  Vec2 normal;                                                ///< unit, out of the body

  bool isHit() const { return distance < 1e300; }
};

/// The nearest place that reflects sound.
struct Echo {
  double distance = std::numeric_limits<double>::infinity();  ///< [m] infinity: none
  Vec2 point;                                                 ///< [m]

  bool isHeard() const { return distance < 1e300; }
};

/// Outlines of bodies and walls for rays of light and cones of sound: straight faces, corners and discs.
/// Answers are exact up to rounding, in doubles, without random numbers.
class EchoScene {
 public:
  /// Drops all outlines; keeps the memory.
  void clear();
  /// A room's contour, counter-clockwise: inside is free. Points nearer than 1 mm to the last are merged.
  void addRoom(std::span<const Vec2> contour) { addOutline(contour, 1.0); }
  /// A convex body's outline, counter-clockwise: outside is free.
  void addBody(std::span<const Vec2> outline) { addOutline(outline, -1.0); }
  void addDisc(Vec2 centre, double radius);

  /// The first surface along the unit vector `direction` from `from`. Rays meet faces from their free side
  /// only; a start inside a disc hits it at once.
  RayHit castRay(Vec2 from, Vec2 direction, double range) const;

  /// The nearest point in the cone that reflects an echo to its apex. That is a visible point
  ///  - of a face or disc where the angle between its normal and the direction back is at most
  ///    `specular_limit` [rad]; beyond it a smooth surface reflects the sound sideways, but still hides what
  ///    is behind it,
  ///  - of a body's corner where that angle to the nearer face is at most the limit, or the direction back
  ///    lies between the normals of its faces,
  ///  - of a room's corner of at most 90 degrees, which reflects sound to its source by two reflections.
  Echo castCone(const Cone& cone, double specular_limit) const;

 private:
  struct Face {
    Vec2 from, to;
    Vec2 normal;  ///< to the free side
  };
  struct Corner {
    Vec2 point;
    Vec2 first, second;  ///< normals of its faces, `second` counter-clockwise of `first` at a body's corner
    bool hollow;         ///< seen from its inside, e.g. a room's corner
  };
  struct Disc {
    Vec2 centre;
    double radius;
  };
  class Listener;

  void addOutline(std::span<const Vec2> points, double free_side);

  std::vector<Face> faces_;
  std::vector<Corner> corners_;
  std::vector<Disc> discs_;
  std::vector<Vec2> distinct_;  ///< points of the outline that is being added
};

}  // namespace fulbito
