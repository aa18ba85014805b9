#pragma once

#include <span>
#include <vector>

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Shows what the team has decided: the ball's way, and of each robot its role and skill, where it goes,
/// where it means to touch the ball and where to send it. `moves` and `roles` are by robot. Changes nothing
/// that is played.
void draw(const Picture& picture, std::span<const Role> roles, std::span<const Move> moves,
          std::vector<DebugDrawing>& drawings);

}  // namespace fulbito::libero
