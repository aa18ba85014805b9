#pragma once

#include "fulbito/detail/vec2.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Motion of a ball on the floor: velocity of its centre and spin, as in BallState.
struct BallMotion {
  Vec2 velocity;  ///< [m/s]
  Vec2 spin;      ///< [m/s]
};

/// The ball's motion after floor friction for `dt` [s]. Sliding friction changes velocity and spin in a fixed
/// proportion, such that `roll_keep` of a kick's speed is left when both are equal. Then the ball rolls,
/// loses speed at a constant rate and stops below `stop_speed`.
BallMotion afterFloor(const BallModel& ball, BallMotion motion, double dt);

/// The spin after an impact with a wall. Its component along the unit normal is multiplied by
/// `wall_spin_keep`.
Vec2 spinAfterWall(const BallModel& ball, Vec2 spin, Vec2 normal);

}  // namespace fulbito
