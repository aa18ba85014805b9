#pragma once

#include <optional>

#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// The ball [m] that robots without the ball look at: after the time of a quarter turn.
Vec2 ballAhead(const Picture& picture);

/// The side of the field without the ball: +1 or -1. For a ball in the middle, as at a penalty, it is the
/// robot's own side. A fixed side would send some robots across the field.
double farSide(Vec2 ball, Vec2 robot);

/// Goes to `place` [m], round mates and opponents, and there turns to `heading` [rad], else to the ball.
Move travel(const Picture& picture, int robot, Vec2 place, const char* reason,
            std::optional<double> heading = {});

/// As `travel`, to the point next to `place` [m] that is not near the striker's ball and in no area.
Move standBy(const Picture& picture, int robot, Vec2 place, const char* reason,
             std::optional<double> heading = {});

}  // namespace fulbito::libero
