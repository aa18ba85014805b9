// Private header of engine/sim: not installed.
#pragma once

#include "engine/core/models/layout.hpp"

class b2Body;

namespace fulbito {

/// Moment of inertia [kg m^2] of a pushable obstacle of even density.
double inertiaOf(const ObstacleSpec& obstacle);

/// Yaw deceleration [rad/s^2] of a pushable obstacle that turns on the floor: friction that is even over its
/// base (a box's as that of the disc of equal area) over its inertia.
double yawDeceleration(const ObstacleSpec& obstacle);

/// Lets the floor slow a pushable obstacle down for one physics step of `dt` [s], by impulses.
void applyFloorFriction(const ObstacleSpec& obstacle, b2Body& body, double dt);

/// Sets a moving obstacle's velocity so that it is on its path at `time` [s], the end of a step of `dt` [s]:
/// aiming at positions, not speeds, keeps rounding from adding up.
void followPath(const ObstacleSpec& obstacle, b2Body& body, double time, double dt);

}  // namespace fulbito
