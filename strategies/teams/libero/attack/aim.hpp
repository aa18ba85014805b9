#pragma once

#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// How the ball should be hit.
struct Aim {
  Vec2 contact;       ///< [m] the point to drive through, off the wall if the ball lies at one
  Vec2 direction;     ///< unit vector along which to push
  bool wall = false;  ///< the ball lies at a wall: push along it
};

/// The y [m] on the opponents' goal line with the widest gap as seen from `from`, for a shooter at
/// `shooter_y`. `last` is the previous result, which is kept while it is nearly as good.
double openMouth(const Picture& picture, Vec2 from, double shooter_y, double last);

/// Whether a ball at `ball` leaves no room for a robot between it and a wall. In front of a goal mouth there
/// is no wall.
bool isAtWall(const Pitch& pitch, Vec2 ball);

/// The aim for a ball at `ball` toward `target`. It leads along the wall if there is no room for a robot
/// behind the ball.
Aim aimAt(const Pitch& pitch, Vec2 ball, Vec2 target);

}  // namespace fulbito::libero
