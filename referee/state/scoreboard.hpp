#pragma once

#include "engine/core/base/team.hpp"

namespace fulbito {

/// Score and time at the start of a match.
struct Scoreboard {
  PerTeam<int> score{};
  int period = 1;             ///< 1, 2: halves; 3: overtime
  double play_seconds = 0.0;  ///< [s] elapsed play time in that period
};

}  // namespace fulbito
