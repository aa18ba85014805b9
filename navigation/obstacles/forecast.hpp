#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "fulbito/navigation.hpp"
#include "navigation/geometry/body_clearance.hpp"

namespace fulbito {

/// A disc obstacle with its motion foreseen: straight on, mirrored where it meets a wall of the field.
struct ForecastDisc {
  Vec2 position;
  Vec2 velocity;
  double radius = 0.0;
  Vec2 room;           ///< [m] |x| and |y| that its centre keeps within
  bool moves = false;  ///< faster than a few centimetres a second

  /// Where its centre will be after `time` [s].
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

/// Foresees all obstacles of `scene` into `out`, reusing its memory; returns whether any of them moves.
bool forecast(const NavigationScene& scene, std::vector<ForecastDisc>& out);

/// Whether the body, if it goes on with `velocity` [m/s] and keeps its direction, meets the disc within
/// `horizon` [s].
bool meetsWithin(const BodyShape& body, Vec2 position, Vec2 along, Vec2 velocity, const ForecastDisc& disc,
                 double horizon);

}  // namespace fulbito
