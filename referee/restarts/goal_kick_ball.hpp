#pragma once

#include <vector>

#include "fulbito/referee.hpp"

namespace fulbito {

/// The call with the ball where the taking team wants it (world frame). Law 13: at a goal kick the ball may
/// be anywhere in the goal area, if the profile allows it; at other restarts `wish` is ignored. A wish that
/// is not finite changes nothing; a wish that is not allowed becomes the nearest allowed place. If the ball
/// then is a millimetre or more from the wish, `log` gets a `placement` event without a robot. The keeper's
/// place in the rules follows the ball. Pure.
RestartCall withBall(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call, Vec2 wish,
                     std::vector<GameEvent>& log);

}  // namespace fulbito
