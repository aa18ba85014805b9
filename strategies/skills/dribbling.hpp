#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito {

/// Whether an opponent pushes the ball toward the own goal: it is at the ball, on the far side of the ball's
/// motion, and the ball's velocity along x is below -0.3 m/s.
bool opponentDribblesAtGoal(const Observation& seen, const BallState& ball);

}  // namespace fulbito
