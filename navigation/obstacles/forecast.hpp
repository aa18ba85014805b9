#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "fulbito/navigation.hpp"
#include "navigation/geometry/body_clearance.hpp"

namespace fulbito {

/// A disc obstacle with a predicted motion: straight on, mirrored at the walls of the field.
struct ForecastDisc {
  Vec2 position;
  Vec2 velocity;
  double radius = 0.0;
  Vec2 room;           ///< [m] greatest |x| and |y| of its centre
  bool moves = false;  ///< whether it is faster than 3 cm/s

  /// Predicted position [m] of its centre after `time` [s].
  Vec2 at(double time) const {
    if (!moves) return position;
    const Vec2 p = position + velocity * time;
    return {mirrored(p.x, room.x), mirrored(p.y, room.y)};
  }

 private:
  static double mirrored(double x, double room) {
    if (x > room) return std::max(2.0 * room - x, -room);
    if (x < -room) return std::min(-2.0 * room - x, room);
    return x;
  }
};

/// Predicts all obstacles of `scene` into `out`, reusing its memory. Returns whether any of them moves.
bool forecast(const NavigationScene& scene, std::vector<ForecastDisc>& out);

/// Whether the body meets the disc within `horizon` [s] if it keeps its `velocity` [m/s] and its direction.
bool meetsWithin(const BodyShape& body, Vec2 position, Vec2 along, Vec2 velocity, const ForecastDisc& disc,
                 double horizon);

}  // namespace fulbito
