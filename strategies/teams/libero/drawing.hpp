#pragma once

#include <span>
#include <vector>

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/roles.hpp"
#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Draws the team's decisions: the predicted ball, and for each robot its role, its skill and the reason, its
/// target, where it will touch the ball and where it will send it. `moves` are by robot number.
void draw(const Picture& picture, const Roles& roles, std::span<const Move> moves,
          std::vector<DebugDrawing>& drawings);

}  // namespace fulbito::libero
