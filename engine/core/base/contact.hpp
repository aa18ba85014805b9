#pragma once

#include <cstdint>

#include "engine/core/base/vec2.hpp"

namespace fulbito {

/// The kinds of bodies that can touch.
enum class BodyKind : std::uint8_t { kWall, kRobot, kBall, kObstacle };

/// One body of a world: its kind and its index in the world's list of that kind (0 for the walls).
struct BodyId {
  BodyKind kind = BodyKind::kWall;
  std::uint16_t index = 0;
  friend bool operator==(BodyId, BodyId) = default;
};

/// Two bodies that pressed on each other during a control tick; being close without force is not a contact.
/// One event per pair and tick, sorted by (a, b), independent of the physics engine's order.
struct ContactEvent {
  BodyId a;  ///< the body that comes first in the order walls, robots, balls, obstacles
  BodyId b;
  Vec2 point;            ///< [m] world frame, at the first impulse of the tick
  Vec2 normal;           ///< unit, from a to b
  double impulse = 0.0;  ///< [kg m/s] along the normal, summed over the tick
  bool began = false;    ///< the two did not touch in the previous tick, with or without force
};

}  // namespace fulbito
