#pragma once

#include <span>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// The highest of five speeds [m/s] (shares of the robot's top speed, down to 0) at which a robot that stays
/// on `path` meets no moving obstacle within `horizon` [s]. Obstacles keep their velocities. If every speed
/// leads to a meeting, it is the speed with the latest one. Infinite if the top speed is free or nothing
/// moves. Path-velocity decomposition (Kant and Zucker, IJRR 1986) with constant speeds.
double yieldSpeed(const NavigationScene& scene, std::span<const Vec2> path, double horizon);

}  // namespace fulbito
