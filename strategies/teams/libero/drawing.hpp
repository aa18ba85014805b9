#pragma once

#include <span>
#include <vector>

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Draws the team's decisions: the predicted ball, and for each robot its role and skill, its target, where
/// it will touch the ball and where it will send it. `moves` and `roles` are by robot number.
void draw(const Picture& picture, std::span<const Role> roles, std::span<const Move> moves,
          std::vector<DebugDrawing>& drawings);

}  // namespace fulbito::libero
