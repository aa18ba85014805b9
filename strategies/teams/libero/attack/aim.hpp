#pragma once

#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// How the ball shall be hit.
struct Aim {
  Vec2 contact;       ///< [m] the point to drive through: the ball's centre, or beside it at a wall
  Vec2 direction;     ///< unit vector along which to push
  bool wall = false;  ///< the ball lies at a wall: push along it
};

/// Where on the opponents' goal line the widest way in is, seen from `from`, for a shooter at `shooter_y`;
/// `last` is kept while it is nearly as good.
double openMouth(const Picture& picture, Vec2 from, double shooter_y, double last);

/// The direction for a ball at `ball` toward `target`, led along the wall where there is no room behind it.
Aim aimAt(const Pitch& pitch, Vec2 ball, Vec2 target);

}  // namespace fulbito::libero
