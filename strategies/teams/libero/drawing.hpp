// Private header of strategies: not installed.
#pragma once

#include <vector>

#include "strategies/interface/team_command.hpp"
#include "strategies/teams/libero/attack/striker.hpp"

namespace fulbito::libero {

/// Who plays what in one tick; -1: nobody.
struct Roles {
  int keeper = -1;
  int striker = -1;
  bool keepers_ball = false;  ///< the ball is the keeper's alone, all others wait
};

/// Shows what the team has in mind: roles, the ball's way, where the striker means to meet the ball and where
/// to send it, the keeper's place and those of the others. Changes nothing that is played.
void draw(const Picture& picture, const Roles& roles, const StrikerMemory& memory,
          std::vector<DebugDrawing>& drawings);

}  // namespace fulbito::libero
