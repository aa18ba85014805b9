#pragma once

#include <vector>

#include "referee/state/game_event.hpp"
#include "referee/state/referee_state.hpp"

namespace fulbito {

/// The call with the ball where the taking team wants it, world frame. Law 13: at a goal kick the ball lies
/// anywhere in the goal area, as far as the profile leaves it free; at other restarts it has its spot. A wish
/// that is not finite leaves the ball where it was, one that is not allowed becomes the nearest place that
/// is, and `log` gets a `placement` event that names no robot where the ball lies a millimetre or more from
/// the wish. Of the rules' own places the keeper's follows the ball. The same arguments give the same result.
RestartCall withBall(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call, Vec2 wish,
                     std::vector<GameEvent>& log);

}  // namespace fulbito
