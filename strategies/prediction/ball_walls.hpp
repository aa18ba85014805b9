#pragma once

#include <optional>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"

namespace fulbito {

/// Evenly accelerated motion of a point, straight or along a parabola, from time 0.
struct EvenMotion {
  Vec2 position;      ///< [m]
  Vec2 velocity;      ///< [m/s]
  Vec2 acceleration;  ///< [m/s^2]

  constexpr Vec2 positionAt(double t) const { return position + velocity * t + acceleration * (0.5 * t * t); }
  constexpr Vec2 velocityAt(double t) const { return velocity + acceleration * t; }
};

/// Least t in [0, `duration`] at which `height + speed t + acceleration t^2 / 2` comes down through 0; at
/// once when it is already below and falls.
std::optional<double> timeOfFall(double height, double speed, double acceleration, double duration);

/// The field's walls as the centre of a ball meets them: the contour with goals, corner cuts and posts,
/// shrunk by the ball's radius. Made once a match.
class BallWalls {
 public:
  BallWalls() = default;
  BallWalls(const FieldGeometry& field, double radius);

  struct Hit {
    double time = 0.0;  ///< [s] from the motion's begin
    Vec2 normal;        ///< unit, into the field
  };
  /// The first touch within `duration` [s], where one is.
  std::optional<Hit> firstHit(const EvenMotion& motion, double duration) const;
  /// Whether a ball centre at `p` is on the playing rectangle and more than `margin` [m] from touching a
  /// wall.
  bool isFree(Vec2 p, double margin = 0.0) const;

 private:
  struct Line {
    Vec2 begin;  ///< of the shrunk wall
    Vec2 normal;
    double length = 0.0;
  };
  void meetLine(const Line& line, const EvenMotion& motion, std::optional<Hit>& first, double& until) const;
  void meetPost(Vec2 post, const EvenMotion& motion, std::optional<Hit>& first, double& until) const;

  double radius_ = 0.0;
  double half_length_ = 0.0, half_width_ = 0.0, half_diagonal_ = 0.0;  ///< of where the centre may be
  std::vector<Line> lines_;
  std::vector<Vec2> posts_;  ///< corners that stick out into the field
};

}  // namespace fulbito
