#pragma once

#include "fulbito/detail/layout.hpp"

class b2Body;

namespace fulbito {

/// Moment of inertia [kg m^2] of a pushable obstacle of uniform density.
double inertiaOf(const ObstacleSpec& obstacle);

/// Yaw deceleration [rad/s^2] of a pushable obstacle that turns on the floor: uniform friction over its base
/// (for a box, that of the disc of equal area), divided by its inertia.
double yawDeceleration(const ObstacleSpec& obstacle);

/// Applies floor friction to a pushable obstacle as impulses for one physics step of `dt` [s].
void applyFloorFriction(const ObstacleSpec& obstacle, b2Body& body, double dt);

/// Sets a moving obstacle's velocity so that it is on its path at `time` [s], the end of a step of `dt` [s].
/// Following positions instead of speeds keeps rounding errors from accumulating.
void followPath(const ObstacleSpec& obstacle, b2Body& body, double time, double dt);

}  // namespace fulbito
