// Private header of engine/sim: not installed.
#pragma once

#include "engine/core/base/vec2.hpp"
#include "engine/core/models/ball_model.hpp"

namespace fulbito {

/// Motion of a ball on the floor: where its centre goes and how it spins, see BallState.
struct BallMotion {
  Vec2 velocity;  ///< [m/s]
  Vec2 spin;      ///< [m/s]
};

/// What the floor makes of a ball's motion in `dt` [s]. Sliding friction acts on the centre and on the spin
/// in the fixed proportion that leaves `roll_keep` of a kick's speed when the two have met; from then on the
/// ball rolls, loses speed evenly and rests below `stop_speed`.
BallMotion afterFloor(const BallModel& ball, BallMotion motion, double dt);

/// The spin after an impact with a wall of unit normal `normal`: of the part along it only `wall_spin_keep`
/// is left.
Vec2 spinAfterWall(const BallModel& ball, Vec2 spin, Vec2 normal);

}  // namespace fulbito
