#pragma once

#include <optional>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {

/// Motion of a point with constant acceleration, straight or along a parabola, from time 0.
struct EvenMotion {
  Vec2 position;      ///< [m]
  Vec2 velocity;      ///< [m/s]
  Vec2 acceleration;  ///< [m/s^2]

  constexpr Vec2 positionAt(double t) const { return position + velocity * t + acceleration * (0.5 * t * t); }
  constexpr Vec2 velocityAt(double t) const { return velocity + acceleration * t; }
};

/// The first time t in [0, `duration`] at which `height + speed t + acceleration t^2 / 2` falls through 0. It
/// is 0 if the height is not positive and falls at the start.
std::optional<double> timeOfFall(double height, double speed, double acceleration, double duration);

/// The field's walls for the centre of a ball: the contour with goals, corner triangles and posts, shrunk by
/// the ball's radius. Made once per match.
class BallWalls {
 public:
  BallWalls() = default;
  BallWalls(const FieldGeometry& field, double radius);

  /// A contact with a wall.
  struct Hit {
    double time = 0.0;  ///< [s] from the start of the motion
    Vec2 normal;        ///< unit vector, into the field
  };
  /// The first contact within `duration` [s]; empty if there is none.
  std::optional<Hit> firstHit(const EvenMotion& motion, double duration) const;
  /// Whether a ball centre at `p` is on the playing rectangle and more than `margin` [m] from touching a
  /// wall.
  bool isFree(Vec2 p, double margin = 0.0) const;

 private:
  struct Line {
    Vec2 begin;  ///< [m] start of the shrunk wall
    Vec2 normal;
    double length = 0.0;
  };
  void meetLine(const Line& line, double height, const EvenMotion& motion, std::optional<Hit>& first,
                double& until) const;
  void meetPost(Vec2 post, const EvenMotion& motion, std::optional<Hit>& first, double& until) const;

  double radius_ = 0.0;
  double half_length_ = 0.0, half_width_ = 0.0,
         half_diagonal_ = 0.0;  ///< [m] of the area for the ball's centre
  std::vector<Line> lines_;
  std::vector<Vec2> posts_;  ///< corners that stick out into the field
};

}  // namespace fulbito
