#pragma once

#include "fulbito/detail/math.hpp"
#include "fulbito/world.hpp"

namespace fulbito::test {

/// The pose of a keeper that faces left in the scene and in its mirror image. So its front and its back are
/// exchanged between the two.
inline Pose2 keeperAt(Vec2 place, double side) { return {place, side * math::kPi / 2}; }

}  // namespace fulbito::test
