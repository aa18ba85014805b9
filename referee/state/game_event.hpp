#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/core/base/team.hpp"
#include "engine/core/base/values.hpp"

namespace fulbito {

/// What a referee's record is made of: one call, with what was measured.
struct GameEvent {
  Tick tick = 0;                      ///< of the match
  double play_time = 0.0;             ///< [s] of play in the period
  std::uint8_t period = 1;            ///< 1, 2: halves; 3: overtime; 4: shoot-out
  std::string_view clause;            ///< name of the rule, e.g. "goal-kick.attackers"; static lifetime
  std::string_view law;               ///< where the rule book says so, e.g. "8.2"; static lifetime
  std::optional<TeamId> team;         ///< whom it is called against; of a goal: who scored
  std::optional<std::uint8_t> robot;  ///< the robot at fault or the scorer, where one is
  Vec2 place;                         ///< [m] world frame: the ball's
  double value = 0.0;                 ///< what was measured, in the unit of the threshold
  double threshold = 0.0;             ///< what the rule allows
  double margin = 0.0;                ///< how far the value is beyond it; positive
};

}  // namespace fulbito
