#pragma once

#include "engine/core/base/team.hpp"

namespace fulbito {

/// How a match stands when it begins: not at 0-0 in the first half where the user says so.
struct Scoreboard {
  PerTeam<int> score{};
  int period = 1;             ///< 1, 2: halves; 3: overtime
  double play_seconds = 0.0;  ///< [s] of play gone in that period
};

}  // namespace fulbito
