#pragma once

#include <span>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// The highest of five speeds [m/s] (shares of the robot's top speed, down to a stop) at which a robot that
/// stays on `path` meets no moving obstacle within `horizon` [s], obstacles keeping their velocities; where
/// every speed meets one, the speed that meets it last. Infinite when the top speed is free or nothing moves.
/// Path-velocity decomposition (Kant and Zucker, IJRR 1986) with constant speeds.
double yieldSpeed(const NavigationScene& scene, std::span<const Vec2> path, double horizon);

}  // namespace fulbito
